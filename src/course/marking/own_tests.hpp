// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/assignment/check.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// What is needed to try the tests that students write themselves.
struct OwnTestsTask {
  const Assignment& assignment;
  std::filesystem::path toolkit;
  const Files& files;             ///< of the submission
  std::filesystem::path scratch;  ///< is made
  /// What compiling and all answers took so far, as JobEnd::seconds; nothing if it does not count.
  std::function<double()> seconds_so_far = [] { return 0.; };
  Isolation isolation = Isolation::sandbox;
};

/// The checks, and one for each exercise that asks for tests. It holds in the share of the wrong
/// programs that the tests catch: they come to their end, and a check does not hold. A crash of the
/// tests, or a limit that they exceed, catches nothing. If they do not accept the right program,
/// before the first wrong one and after each, they have no points, and the message names the line
/// of the first check that does not hold, and nothing that the tests wrote. Of wrong programs it
/// tells how many there are and how many are caught.
///
/// The tests run in the sandbox and apart from the program that they try, of which they get numbers
/// only (course/assignment/replay.hpp): what they say of it follows from what it answers. They are
/// run again until they ask what they asked before, with the answers to that; all programs begin
/// with the questions of the right one. All their questions are about one
/// task, since the right program's answers to others would tell them what is right. All this may
/// take one exercise's share of Limits::submission_seconds, and no more than is left of these.
///
/// When the checks are tried, a line for each wrong program that is not caught, for the instructor,
/// is added to `missed`.
Checks with_own_tests(Checks checks, const OwnTestsTask& task, std::vector<std::string>& missed);

/// The checks, and one for each exercise that asks for tests, of which the share holds anyway.
Checks without_own_tests(Checks checks, const Assignment& assignment, double share);

}  // namespace course

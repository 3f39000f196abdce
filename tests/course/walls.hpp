// SPDX-License-Identifier: GPL-3.0-or-later
// What a suite of tests does where bubblewrap cannot work: in a chroot, or in a container that
// forbids namespaces.
#pragma once

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <string>

#include "course/sandbox/sandbox.hpp"
#include "needed_tool.hpp"
#include "temporary_folder.hpp"

/// What keeps this machine from running jobs in walls; empty if nothing does.
inline std::string missing_walls() {
  const TemporaryFolder work;
  try {
    const course::Sandbox tried(course::Isolation::sandbox, work.path());
    return "";
  } catch (const sys::ToolError& e) {
    return e.what();
  }
}

/// Ends the program as skipped, with one line that says what is missing; unless CI is "true".
inline void skip_for(const std::string& missing) {
  const char* ci = std::getenv("CI");
  if (ci != nullptr && std::string(ci) == "true") return;
  skip_tests("what runs submissions in walls was not tested", missing);
}

/// Ends the program as skipped, with one line that says why, if there can be no walls here and CI
/// is not "true": continuous integration must have them. A fixture of a whole suite, which CTest
/// runs as a program of its own: BOOST_AUTO_TEST_SUITE(x_test,
/// *boost::unit_test::fixture(&need_walls)).
inline void need_walls() {
  const std::string missing = missing_walls();
  if (!missing.empty()) skip_for(missing);
}

/// Does the same where reports cannot be drawn and typeset.
inline void need_walls_and_tex() {
  need_walls();
  try {
    for (const char* tool : {"gnuplot", "pdflatex"}) sys::find_tool(tool);
  } catch (const sys::ToolError& e) {
    skip_for(e.what());
  }
}

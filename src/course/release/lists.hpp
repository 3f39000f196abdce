// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "course/assignment/assignment.hpp"

namespace course {

/// Fills the lists of a file of the template, so that what names all exercises follows from
/// assignment.toml alone. A list is a comment on a line of its own,
///
///     // EACH EXERCISE: #include "assignment/exercises/@name@.hpp"
///     // EACH PUBLIC CHECK: {@number@, "@check@", @points@},
///     # EACH OWN TESTS: add_executable(@check@ @tests@)
///
/// in whose place its text stands once for each exercise, each public check or each exercise that
/// asks for tests, with the indentation and line end of that line. In it `@number@` is the number
/// of the exercise, from 1; `@name@` the name of its file without folder and ending; `@file@` its
/// file; `@id@` and `@title@` are as assignment.toml has them; `@points@` are those of the exercise
/// or check; `@check@` and
/// `@says@` are the id and the words of the check; and `@tests@` is the file of tests.
///
/// Throws sys::SourceError «file:line: …» for a list of something else, and for another word
/// between two @.
std::string with_lists(const Assignment& assignment, std::string_view text,
                       const std::string& file);

}  // namespace course

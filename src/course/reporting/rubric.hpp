// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/class_marks.hpp"

namespace course {

/// The names under which markers see who handed in, by these names: 'report-' and ten hexadecimal
/// digits of SHA-256 of seed and student or group. Who does not know the seed cannot tell one from
/// the other. Throws std::logic_error if two had one name, which a class of thousands never meets.
std::map<std::string, std::string> anonymous_names(const std::vector<std::string>& units,
                                                   const std::string& seed);

/// A line of the markers' file.
struct RubricLine {
  std::string unit;  ///< student or group
  std::string criterion;
  CriterionMark mark;
  std::string place;           ///< «file:line:column» of the student
  bool is_drawn_name = false;  ///< the student is a name that was drawn, and the seed is not given
};

/// Reads the markers' file, CSV with the columns student, criterion, points, comment and marker;
/// a line without points is one that nobody has marked yet. `names` are those of anonymous_names,
/// which may stand for the students. Throws sys::SourceError «file:line:column: …» for another
/// column or one that is missing, a criterion that the assignment does not have, points that it
/// cannot give, points without a marker, and a second line for the same.
std::vector<RubricLine> read_rubric_lines(const Assignment& assignment,
                                          const std::filesystem::path& file,
                                          const std::map<std::string, std::string>& names);

/// Says that the points of the report are missing where the rubric has criteria and no markers'
/// file is given; empty without a rubric.
std::string without_markers_file(const Assignment& assignment);

/// Gives each student with a mark, or all members of a group, what the lines say, and adds up anew;
/// who handed in no report has nothing for each criterion. What is still to be marked, and a line
/// for somebody without a mark, become problems of the class; of lines whose names were drawn from
/// a seed that is not given only the first one does.
void apply_rubric(const Assignment& assignment, const std::vector<RubricLine>& lines,
                  ClassMarks& marks);

/// The markers' file as it begins: a line for each criterion of each name.
std::string rubric_form(const Assignment& assignment, const std::vector<std::string>& names);

}  // namespace course

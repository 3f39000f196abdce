// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/roster.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "course/assignment/student.hpp"
#include "course/assignment/student_text.hpp"
#include "course/marking/csv.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// The place of a column in the header, or its end.
std::size_t column(const std::vector<std::string>& header, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(header, name) - header.begin());
}

/// Where the columns are that count; those that are not there are at the header's end.
struct Columns {
  explicit Columns(const std::vector<std::string>& header)
      : student(column(header, "student")),
        submitted(column(header, "submitted")),
        deadline(column(header, "deadline")) {}

  std::size_t student, submitted, deadline;
};

std::optional<Time> time_in(const std::vector<std::string>& fields, std::size_t column) {
  if (column >= fields.size() || fields[column].empty()) return std::nullopt;
  return parse_time(fields[column]);
}

void add_student(Roster& roster, const std::vector<std::string>& fields, const Columns& columns) {
  const std::string& student = fields[columns.student];
  require_student_id(student);
  const RosterEntry entry{.submitted = time_in(fields, columns.submitted),
                          .deadline = time_in(fields, columns.deadline)};
  if (!roster.emplace(student, entry).second) {
    throw sys::SourceError(fmt::format("student {} is listed twice", student));
  }
}

/// Why an entry of the folder is no submission; empty if it is one.
std::string refusal(const fs::path& path, const std::optional<Roster>& roster) {
  const fs::file_status status = fs::symlink_status(path);
  const std::string name = shown_name(path.filename().string());
  if (!fs::is_directory(status) && !(fs::is_regular_file(status) && names_archive(path))) {
    return fmt::format(
        "'{}' is neither a folder nor an archive (.zip, .tar, .tar.gz, .tgz, .tar.xz)", name);
  }
  const std::string student = student_of(path);
  try {
    require_student_id(student);
  } catch (const sys::SourceError& error) {
    return fmt::format("'{}' is not named for a student: {}", name, error.what());
  }
  if (roster && !roster->contains(student)) {
    return fmt::format("'{}': there is no student {} in the class", name, student);
  }
  return "";
}

}  // namespace

Roster read_roster(const fs::path& file) {
  const std::string text = sys::read_file(file);
  const auto lines = sys::lines_of(text);
  const auto fail = [&](std::size_t line, const std::string& message) {
    throw sys::SourceError(fmt::format("{}:{}: {}", file.string(), line, message));
  };
  if (lines.empty()) fail(1, "the class is empty; a header line with 'student' is wanted");
  std::string_view first = lines[0];
  if (first.starts_with("\xEF\xBB\xBF")) first.remove_prefix(3);
  const std::vector<std::string> header = csv_fields(first);
  const Columns columns(header);
  if (columns.student == header.size()) fail(1, "there is no column 'student'");
  Roster roster;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (sys::stripped(lines[i]).empty()) continue;
    const std::vector<std::string> fields = csv_fields(lines[i]);
    if (fields.size() != header.size()) {
      fail(i + 1, fmt::format("{} fields; the header has {}", fields.size(), header.size()));
    }
    try {
      add_student(roster, fields, columns);
    } catch (const sys::SourceError& error) {
      fail(i + 1, error.what());
    }
  }
  return roster;
}

Listing list_submissions(const fs::path& folder, const std::optional<Roster>& roster) {
  Listing listing;
  std::vector<fs::path> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) paths.push_back(entry.path());
  if (error) {
    throw sys::OutputError(fmt::format("cannot list '{}': {}", folder.string(), error.message()));
  }
  std::ranges::sort(paths);
  std::map<std::string, std::vector<fs::path>> by_student;
  for (const fs::path& path : paths) {
    if (path.filename().string().starts_with('.')) continue;
    const std::string why = refusal(path, roster);
    if (why.empty()) {
      by_student[student_of(path)].push_back(path);
    } else {
      listing.problems.push_back(why);
    }
  }
  for (const auto& [student, theirs] : by_student) {
    if (theirs.size() == 1) {
      listing.entries.push_back({student, theirs.front()});
      continue;
    }
    listing.problems.push_back(fmt::format("student {} has more than one submission: '{}' and '{}'",
                                           student, theirs[0].filename().string(),
                                           theirs[1].filename().string()));
  }
  return listing;
}

}  // namespace course

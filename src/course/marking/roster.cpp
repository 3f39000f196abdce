// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/roster.hpp"

#include <fmt/core.h>

#define CSV_IO_NO_THREAD
#include <libfccp/csv.h>

#include <algorithm>

#include "course/assignment/student.hpp"
#include "course/assignment/student_text.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

using Reader = io::CSVReader<4, io::trim_chars<' ', '\t'>, io::double_quote_escape<',', '"'>,
                             io::throw_on_overflow, io::empty_line_comment>;

/// What the library found wrong in a file, in this program's words.
std::string message_of(const io::error::base& error) {
  using namespace io::error;
  if (dynamic_cast<const header_missing*>(&error) != nullptr) {
    return "the class is empty; a header line with 'student' is wanted";
  }
  if (dynamic_cast<const too_few_columns*>(&error) != nullptr) {
    return "there are fewer fields than the header has";
  }
  if (dynamic_cast<const too_many_columns*>(&error) != nullptr) {
    return "there are more fields than the header has";
  }
  if (dynamic_cast<const escaped_string_not_closed*>(&error) != nullptr) {
    return "a quote is not closed";
  }
  if (const auto* extra = dynamic_cast<const extra_column_in_header*>(&error)) {
    return fmt::format(
        "there is a column '{}'; the columns are student, name, submitted and deadline",
        shown_name(extra->column_name));
  }
  const auto* doubled = dynamic_cast<const duplicated_column_in_header*>(&error);
  return doubled == nullptr ? "the line is not CSV"
                            : fmt::format("there are two columns '{}'", doubled->column_name);
}

std::optional<Time> time_in(const std::string& field) {
  return field.empty() ? std::nullopt : std::optional(parse_time(field));
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
  Reader reader(file.string(), text.data(), text.data() + text.size());
  const auto error_in_line = [&](const std::string& message) {
    return sys::SourceError(
        fmt::format("{}:{}: {}", file.string(), std::max(1U, reader.get_file_line()), message));
  };
  Roster roster;
  try {
    // A column that nobody reads is refused: it could be a misspelt one, and lateness would be off
    // without a word.
    reader.read_header(io::ignore_missing_column, "student", "name", "submitted", "deadline");
    if (!reader.has_column("student")) throw sys::SourceError("there is no column 'student'");
    std::string student, name, submitted, deadline;
    while (reader.read_row(student, name, submitted, deadline)) {
      require_student_id(student);
      const RosterEntry entry{.submitted = time_in(submitted), .deadline = time_in(deadline)};
      if (!roster.emplace(student, entry).second) {
        throw sys::SourceError(fmt::format("student {} is listed twice", student));
      }
    }
  } catch (const io::error::base& error) {
    throw error_in_line(message_of(error));
  } catch (const sys::SourceError& error) {
    throw error_in_line(error.what());
  }
  return roster;
}

std::string lateness_source(const Roster& roster) {
  const auto n_known = std::ranges::count_if(
      roster, [](const auto& entry) { return entry.second.submitted.has_value(); });
  return n_known == 0 ? "the class has no time in a column 'submitted': nobody is late"
                      : fmt::format("lateness from column 'submitted': {} of {} students", n_known,
                                    roster.size());
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

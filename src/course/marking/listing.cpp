// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/submission.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "course/assignment/student.hpp"
#include "system/error.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// Why an entry of the folder is no submission; empty if it is one.
std::string refusal(const fs::path& path, const std::optional<Roster>& roster) {
  const fs::file_status status = fs::symlink_status(path);
  const std::string name = shown_name(path.filename().string());
  if (!fs::is_directory(status) && !(fs::is_regular_file(status) && names_archive(path))) {
    return fmt::format("'{}' is neither a folder nor an archive ({})", name, archive_endings());
  }
  const std::string student = student_of(path);
  try {
    require_student_id(student);
  } catch (const sys::SourceError& error) {
    return fmt::format("'{}' is not named for a student: {}", name, error.what());
  }
  if (!roster || !members_of(*roster, student).empty()) return "";
  if (!roster->contains(student)) {
    return fmt::format("'{}': there is no student {} in the class", name, student);
  }
  return fmt::format("'{}': student {} hands in with group {}, for which it must be named", name,
                     student, roster->at(student).group);
}

}  // namespace

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

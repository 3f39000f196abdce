// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/marking/roster.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// A submission in the folder of all.
struct Entry {
  std::string student;  ///< or group
  std::filesystem::path path;
};

/// The submissions to grade, sorted by student, and a line for each entry of the folder that is
/// no submission, is from somebody who is not in the class or hands in with a group, or is one of
/// several from the same student.
struct Listing {
  std::vector<Entry> entries;
  std::vector<std::string> problems;
};

/// Lists the submissions in a folder. Throws OutputError if it is no folder or cannot be read.
Listing list_submissions(const std::filesystem::path& folder, const std::optional<Roster>& roster);

/// The files taken from a submission, and what is wrong with it.
struct Submission {
  Files files;              ///< those of the exercises that can be given to the compiler
  bool has_report = false;  ///< whether there is a report/report.tex, which a person marks
  std::vector<std::string> problems;  ///< a line each, which may be shown
};

/// Takes the exercises' files from a folder or archive and reads nothing else in it. They may
/// be at the top or in one folder below. A file that is no regular text file within the limits is
/// left out with a line in `problems`. If none is found, a line says where else there is one, or
/// that there is an archive; for each that is missing, a line names what is called nearly so.
/// `work` is a folder for the sandbox. Throws OutputError if the submission is neither a folder nor
/// an archive, or cannot be taken at all: if it is empty, damaged, too large, or holds the files in
/// two places. Then it waits for a person.
Submission take_submission(const Assignment& assignment, const std::filesystem::path& submission,
                           const std::filesystem::path& work, Isolation isolation);

/// A student's own report.
struct Report {
  /// report/report.tex and report/report.pdf, as far as they are there and can be read.
  Files files;
  /// Why a report.tex that is there cannot be read, as «is larger than 20480 kB».
  std::string fault;

  /// Whether there is something for a person to mark.
  bool is_there() const { return !files.empty() || !fault.empty(); }
};

/// Takes the report, files no larger than a submission may be; nothing of a submission that cannot
/// be read. Throws as take_submission does.
Report take_report(const Assignment& assignment, const std::filesystem::path& submission,
                   const std::filesystem::path& work, Isolation isolation);

/// The folder, "" or "name/", that holds the wanted files among these entries; the top is
/// preferred. Throws std::invalid_argument if several folders hold them.
std::string place_of_files(const std::vector<std::string>& entries,
                           const std::vector<std::string>& wanted);

/// Why a text cannot be the file of an exercise; empty if it can.
std::string fault_of(std::string_view text);

/// Reads a regular file below a folder that somebody else wrote. It follows no symbolic link
/// and reads nothing but a regular file. Throws std::invalid_argument whose message completes «file
/// …»: "is missing", "is a symbolic link", "is larger than 256 kB".
std::string read_beneath(const std::filesystem::path& folder, const std::string& file,
                         std::size_t max_bytes);

}  // namespace course

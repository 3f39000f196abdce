// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/submission.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/case_conv.hpp>
#include <locale>
#include <map>
#include <set>
#include <stdexcept>

#include "course/assignment/student.hpp"
#include "course/marking/archive.hpp"
#include "system/error.hpp"
#include "system/nearest_name.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr const char* report = "report/report.tex";
constexpr const char* report_pdf = "report/report.pdf";
constexpr int max_entries = 20'000;  ///< in a folder; no homework has more
constexpr int max_depth = 16;        ///< of folders in one another

std::vector<std::string> wanted_files(const Assignment& assignment) {
  std::set<std::string> files;
  for (const Exercise& exercise : assignment.exercises) {
    files.insert(exercise.file);
    if (!exercise.tests.empty()) files.insert(exercise.tests);
  }
  return {files.begin(), files.end()};
}

std::vector<std::string> below(const std::string& place, std::vector<std::string> files) {
  for (std::string& file : files) file.insert(0, place);
  return files;
}

/// Everything in a folder, whatever its kind, but the history of its repository; links are not
/// followed. Throws std::invalid_argument for folders that are too deep in one another.
struct Contents {
  std::vector<std::string> entries;
  std::uintmax_t bytes = 0;
};

Contents contents_of(const fs::path& folder) {
  Contents contents;
  std::error_code error;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator entry(folder, options, error), end;
       !error && entry != end && contents.entries.size() < max_entries; entry.increment(error)) {
    std::error_code unreadable;
    if (entry->path().filename() == ".git") {
      entry.disable_recursion_pending();
      continue;
    }
    if (entry.depth() >= max_depth) {
      throw std::invalid_argument(
          fmt::format("the submission has more than {} folders in one another", max_depth));
    }
    contents.entries.push_back(entry->path().lexically_relative(folder).generic_string());
    if (!entry->is_symlink(unreadable) && entry->is_regular_file(unreadable)) {
      contents.bytes += entry->file_size(unreadable);
    }
  }
  return contents;
}

bool stands_in(const std::vector<std::string>& entries, const std::string& entry) {
  return std::ranges::find(entries, entry) != entries.end();
}

/// Throws std::invalid_argument for a folder that holds nothing, or more than homework.
void require_homework(const Limits& limits, const Contents& contents) {
  if (contents.entries.empty()) {
    throw std::invalid_argument("the submission is empty, or cannot be read");
  }
  if (contents.entries.size() >= max_entries) {
    throw std::invalid_argument(fmt::format("the submission has {} files or more", max_entries));
  }
  if (contents.bytes > static_cast<std::uintmax_t>(limits.submission_mb) * 1'048'576) {
    throw std::invalid_argument(
        fmt::format("the submission is larger than {} MB", limits.submission_mb));
  }
}

/// Where a submission has what was looked for in vain, in a line for the student; empty if it is
/// nowhere.
std::string place_of_the_missing(const std::vector<std::string>& entries,
                                 const std::vector<std::string>& wanted) {
  for (const std::string& entry : entries) {
    for (const std::string& file : wanted) {
      if (!entry.ends_with("/" + file)) continue;
      return fmt::format(
          "there is {} in '{}', but files are looked for at the top and one folder below it", file,
          shown_name(entry.substr(0, entry.size() - file.size())));
    }
  }
  for (const std::string& entry : entries) {
    if (!names_archive(entry)) continue;
    return fmt::format("there is an archive in the submission, '{}'; nothing is taken from that",
                       shown_name(entry));
  }
  return "";
}

/// The name of a file without case and without what a browser or a system appends to it:
/// Quadrature.cpp.txt and quadrature.cpp are alike.
std::string like(std::string_view path) {
  std::string name(path.substr(path.rfind('/') + 1));
  boost::algorithm::to_lower(name, std::locale::classic());
  if (name.ends_with(".txt")) name.resize(name.size() - 4);
  return name;
}

/// Whether a name in lower case is that of a file which may have been meant for the compiler.
bool is_source(const std::string& name) {
  return std::ranges::any_of(std::array{".cpp", ".cc", ".cxx", ".c++", ".c"},
                             [&](const char* ending) { return name.ends_with(ending); });
}

/// The entry whose name is nearest to that of a wanted file, among those that are no wanted file
/// where it belongs; empty if none is near.
std::string nearest_entry(const std::vector<std::string>& entries,
                          const std::vector<std::string>& wanted, const std::string& place,
                          const std::string& file) {
  std::map<std::string, std::string> entry_of;
  std::set<std::string> names;
  for (const std::string& entry : entries) {
    const bool is_where_it_belongs = std::ranges::any_of(
        wanted, [&](const std::string& another) { return entry == place + another; });
    const std::string name = like(entry);
    if (is_where_it_belongs || !is_source(name)) continue;
    entry_of.emplace(name, entry);
    names.insert(name);
  }
  const auto nearest = sys::nearest_name(like(file), names);
  return nearest ? entry_of.at(*nearest) : "";
}

/// Says what is there in place of what is missing.
void explain_missing(const std::vector<std::string>& entries,
                     const std::vector<std::string>& wanted, const std::string& place,
                     Submission& submission) {
  const bool has_any = std::ranges::any_of(
      wanted, [&](const std::string& file) { return stands_in(entries, place + file); });
  if (!has_any) {
    std::string where = place_of_the_missing(entries, wanted);
    if (!where.empty()) {
      submission.problems.push_back(std::move(where));
      return;
    }
  }
  for (const std::string& file : wanted) {
    if (stands_in(entries, place + file)) continue;
    const std::string other = nearest_entry(entries, wanted, place, file);
    if (other.empty()) continue;
    submission.problems.push_back(
        fmt::format("there is '{}', but {} is looked for", shown_name(other), file));
  }
}

/// Throws std::invalid_argument if no wanted file can be taken, unless a report was handed in
/// alone.
void require_something(const Submission& submission) {
  if (!submission.files.empty()) return;
  const auto telling =
      std::find_if(submission.problems.rbegin(), submission.problems.rend(),
                   [](const std::string& problem) { return !problem.ends_with("is missing"); });
  if (telling != submission.problems.rend()) throw std::invalid_argument(*telling);
  if (submission.has_report) return;
  throw std::invalid_argument("none of the files that are looked for is in it");
}

/// Whether a submission is an archive and not a folder. Throws OutputError if it is neither.
bool is_archive(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path, error);
  const bool is_one = fs::is_regular_file(status) && names_archive(path);
  if (!is_one && !fs::is_directory(status)) {
    throw sys::OutputError(fmt::format("'{}' is neither a folder nor an archive ({})",
                                       shown_name(path.string()), archive_endings()));
  }
  return is_one;
}

/// A folder or archive that was handed in. Throws as is_archive, and std::invalid_argument for what
/// is no homework or cannot be read.
class HandedIn {
 public:
  HandedIn(const Limits& limits, const fs::path& path, const fs::path& work, Isolation isolation)
      : limits_(limits), path_(path) {
    if (is_archive(path)) {
      archive_.emplace(limits, path, work, isolation);
      entries_ = archive_->entries();
    } else {
      Contents contents = contents_of(path);
      require_homework(limits, contents);
      entries_ = std::move(contents.entries);
    }
  }

  const std::vector<std::string>& entries() const { return entries_; }
  bool climbs_out() const { return archive_ && archive_->climbs_out(); }

  /// Puts aside all else, as far as that makes reading quicker.
  void keep(const std::vector<std::string>& entries) {
    if (archive_) archive_->keep(entries);
  }
  std::string read(const std::string& entry) {
    const auto max_bytes = static_cast<std::size_t>(limits_.file_kb) * 1024;
    return archive_ ? archive_->read(entry) : read_beneath(path_, entry, max_bytes);
  }

 private:
  Limits limits_;
  fs::path path_;
  std::optional<Archive> archive_;
  std::vector<std::string> entries_;
};

Submission taken_from(HandedIn handed_in, const std::vector<std::string>& wanted) {
  const std::vector<std::string>& entries = handed_in.entries();
  const std::string place = place_of_files(entries, wanted);
  Submission submission;
  if (handed_in.climbs_out()) {
    submission.problems.emplace_back(
        "the archive has entries that lead out of its folder; they are ignored");
  }
  submission.has_report = stands_in(entries, place + report);
  handed_in.keep(below(place, wanted));
  for (const std::string& file : wanted) {
    // `tar -r` appends a file again, and which one is meant, a person has to ask.
    if (std::ranges::count(entries, place + file) > 1) {
      throw std::invalid_argument(fmt::format("the archive holds {} more than once", file));
    }
    try {
      const std::string text = handed_in.read(place + file);
      const std::string fault = fault_of(text);
      if (!fault.empty()) throw std::invalid_argument(fault);
      submission.files[file] = text;
    } catch (const std::invalid_argument& error) {
      submission.problems.push_back(fmt::format("{} {}", file, error.what()));
    }
  }
  explain_missing(entries, wanted, place, submission);
  require_something(submission);
  return submission;
}

}  // namespace

std::string place_of_files(const std::vector<std::string>& entries,
                           const std::vector<std::string>& wanted) {
  std::set<std::string> places;
  for (const std::string& entry : entries) {
    for (const std::string& file : wanted) {
      if (entry == file) return "";
      if (!entry.ends_with("/" + file)) continue;
      const std::string place = entry.substr(0, entry.size() - file.size());
      const bool is_one_folder = place.find('/') == place.size() - 1 && place.size() > 1;
      if (is_one_folder && place != "../" && place != "./") places.insert(place);
    }
  }
  if (places.size() <= 1) return places.empty() ? "" : *places.begin();
  throw std::invalid_argument(fmt::format(
      "the submission holds files in two places, '{}' and '{}', of which one is looked for",
      shown_name(*places.begin()), shown_name(*std::next(places.begin()))));
}

std::string fault_of(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == text.npos) return "is empty";
  const auto null = text.find('\0');
  if (null != text.npos) {
    return fmt::format("is no text in UTF-8: byte {} is zero", null + 1);
  }
  return "";
}

Submission take_submission(const Assignment& assignment, const fs::path& path, const fs::path& work,
                           Isolation isolation) {
  try {
    return taken_from({assignment.limits, path, work, isolation}, wanted_files(assignment));
  } catch (const std::invalid_argument& fault) {
    throw sys::OutputError(
        fmt::format("'{}' cannot be taken: {}", shown_name(path.string()), fault.what()));
  }
}

Report take_report(const Assignment& assignment, const fs::path& path, const fs::path& work,
                   Isolation isolation) {
  Limits limits = assignment.limits;
  limits.file_kb = 1024 * limits.submission_mb;  // a PDF is larger than a source file
  Report taken;
  try {
    HandedIn handed_in(limits, path, work, isolation);
    const std::string place = place_of_files(handed_in.entries(), wanted_files(assignment));
    handed_in.keep(below(place, {report, report_pdf}));
    for (const std::string file : {report, report_pdf}) {
      if (!stands_in(handed_in.entries(), place + file)) continue;
      try {
        taken.files[file] = handed_in.read(place + file);
      } catch (const std::invalid_argument& error) {
        if (file == report) taken.fault = error.what();
      }
    }
  } catch (const std::invalid_argument&) {
    return {};
  }
  return taken;
}

}  // namespace course

// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/archive.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "course/assignment/student.hpp"
#include "system/process.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr int listing_kb = 1024;
constexpr int listing_seconds = 10;

/// Without one, bsdtar would ask for the passphrase of a locked archive for ever.
constexpr const char* no_passphrase = "--passphrase=none";

/// The name with slashes between its folders: some programs of Windows write backslashes, and no
/// slash at all.
std::string with_slashes(std::string name) {
  if (name.find('/') == name.npos) std::ranges::replace(name, '\\', '/');
  return name;
}

std::string without_here(std::string name) {
  while (name.starts_with("./")) name.erase(0, 2);
  return name;
}

/// An entry's name, and the pattern by which bsdtar finds it: an argument in which it could not
/// convert a byte that is no UTF-8, so that `?`, any character, stands for what it escaped.
struct Listed {
  std::string name, pattern;
};

/// Reads a line of bsdtar's list: it writes \\ for a backslash, \n and such for white space, and
/// \ooo for any other byte that it cannot print.
Listed listed_in(std::string_view line) {
  constexpr std::string_view letters = "abfnrtv\\";
  constexpr std::string_view meant = "\a\b\f\n\r\t\v\\";
  Listed listed;
  while (!line.empty()) {
    std::size_t n_read = 1;
    char character = line.front();
    bool is_escaped = false;  // because it is unprintable, or no UTF-8
    if (character == '\\' && line.size() > 1) {
      const auto letter = letters.find(line[1]);
      unsigned byte = 0;
      const auto [end, error] = std::from_chars(
          line.data() + 1, line.data() + std::min<std::size_t>(4, line.size()), byte, 8);
      if (letter != letters.npos) {
        character = meant[letter];
        is_escaped = line[1] != '\\';
        n_read = 2;
      } else if (error == std::errc{}) {
        character = static_cast<char>(byte);
        is_escaped = true;
        n_read = static_cast<std::size_t>(end - line.data());
      }
    }
    const bool is_special = std::string_view("*?[]\\").find(character) != std::string_view::npos;
    listed.name += character;
    if (is_special) listed.pattern += '\\';
    listed.pattern += is_escaped ? '?' : character;
    line.remove_prefix(n_read);
  }
  return listed;
}

bool leads_out(const std::string& name) {
  const fs::path path(name);
  return path.is_absolute() || std::ranges::find(path, fs::path("..")) != path.end();
}

}  // namespace

Archive::Archive(const Limits& limits, const fs::path& file, fs::path work, Isolation isolation,
                 int unpacking_seconds)
    : limits_(limits),
      work_(std::move(work)),
      sandbox_(isolation, work_),
      copy_{work_ / "archive", "/archive"},
      unpacking_seconds_(unpacking_seconds),
      seconds_left_(unpacking_seconds) {
  // The history of a repository, which is not read, may be in it.
  const int most_mb = 10 * limits.submission_mb;
  if (fs::file_size(file) > static_cast<std::uintmax_t>(most_mb) * 1'048'576) {
    throw std::invalid_argument(fmt::format("the archive is larger than {} MB", most_mb));
  }
  fs::copy_file(file, copy_.path);
  make_readable(copy_.path);
  list();
}

JobEnd Archive::run(const std::vector<std::string>& arguments, int seconds, int file_kb) const {
  Job job;
  job.command = {"/usr/bin/env", "LC_ALL=C.UTF-8", sys::find_tool("bsdtar")};
  job.command.insert(job.command.end(), arguments.begin(), arguments.end());
  job.readable = {copy_};
  job.output = work_ / "archive.out";
  job.errors = work_ / "archive.err";
  job.seconds = seconds;
  job.memory_mb = limits_.memory_mb;
  job.processes = limits_.processes;
  job.file_kb = file_kb;
  return sandbox_.run(job);
}

/// Throws std::invalid_argument if the time is over.
JobEnd Archive::unpack(const std::vector<std::string>& arguments, int file_kb) {
  JobEnd end{.ending = Ending::too_slow};
  if (seconds_left_ > 0) {
    end = run(arguments, std::max(1, static_cast<int>(seconds_left_)), file_kb);
    seconds_left_ -= end.seconds;
  }
  if (end.ending == Ending::too_slow) {
    seconds_left_ = 0;
    throw std::invalid_argument(
        fmt::format("is not unpacked: the archive takes longer than {} s", unpacking_seconds_));
  }
  return end;
}

void Archive::list() {
  const JobEnd end =
      run({"-tf", sandbox_.place(copy_), no_passphrase}, listing_seconds, listing_kb);
  if (end.ending == Ending::too_slow)
    throw std::invalid_argument("the archive takes too long to list");
  if (end.ending == Ending::too_much_output) {
    throw std::invalid_argument("the archive has more entries than any homework");
  }
  if (end.ending != Ending::normal || end.status != 0) {
    std::string why = beginning_of(work_ / "archive.err", 1000);
    why = shown_name(why.substr(0, why.find('\n')));
    if (why.starts_with("bsdtar: ")) why.erase(0, 8);
    throw std::invalid_argument(fmt::format("the archive cannot be read: {}", why));
  }
  const std::string listing = beginning_of(work_ / "archive.out", listing_kb * 1024);
  for (const std::string_view line : sys::lines_of(listing)) {
    Listed listed = listed_in(line);
    climbs_out_ = climbs_out_ || leads_out(listed.name);
    entries_.push_back(without_here(with_slashes(std::move(listed.name))));
    patterns_.push_back(std::move(listed.pattern));
  }
  if (entries_.empty()) throw std::invalid_argument("the archive is empty");
}

void Archive::keep(const std::vector<std::string>& entries) {
  // bsdtar would copy what does not fit the checksums that a zip and a 7z have.
  const std::string sign = beginning_of(copy_.path, 2);
  if (sign == "PK" || sign == "7z") return;
  // Here bsdtar takes no passphrase; within walls there is no terminal at which it could ask.
  std::vector<std::string> arguments = {"-cf", "-", "--format=gnutar"};
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (std::ranges::find(entries, entries_[i]) == entries.end()) continue;
    arguments.push_back("--include=" + patterns_[i]);
  }
  if (arguments.size() == 3) return;
  arguments.push_back("@" + sandbox_.place(copy_));
  try {
    const JobEnd end = unpack(arguments, 1024 * limits_.submission_mb);
    // Otherwise `read` finds out which entry is too large, damaged or locked.
    if (end.ending != Ending::normal || end.status != 0) return;
    fs::rename(work_ / "archive.out", copy_.path);
    make_readable(copy_.path);
  } catch (const std::invalid_argument&) {
    // No time is left, as `read` will tell.
  }
}

std::string Archive::read(const std::string& entry) {
  const auto found = std::ranges::find(entries_, entry);
  if (found == entries_.end()) throw std::invalid_argument("is missing");
  const std::string& pattern = patterns_[static_cast<std::size_t>(found - entries_.begin())];
  if (std::ranges::count(patterns_, pattern) > 1) {
    throw std::invalid_argument("is in the archive more than once");
  }
  const JobEnd end =
      unpack({"-xOf", sandbox_.place(copy_), no_passphrase, "--", pattern}, limits_.file_kb);
  if (end.ending == Ending::too_much_output) {
    throw std::invalid_argument(fmt::format("is larger than {} kB", limits_.file_kb));
  }
  if (end.ending != Ending::normal || end.status != 0) {
    throw std::invalid_argument("cannot be unpacked: the archive is damaged or locked");
  }
  const std::string text =
      beginning_of(work_ / "archive.out", static_cast<std::size_t>(limits_.file_kb) * 1024);
  if (text.empty()) throw std::invalid_argument("is empty, a link, or no file");
  return text;
}

}  // namespace course

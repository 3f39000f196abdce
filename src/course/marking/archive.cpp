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
constexpr int archive_seconds = 10;

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

/// A character of a name as bsdtar lists it.
struct Listed {
  char character;
  bool is_escaped;  ///< because it is unprintable, or no UTF-8
};

/// The characters of a name that bsdtar listed: it writes \\ for a backslash, \n and such for white
/// space, and \ooo for any other byte that it cannot print.
std::vector<Listed> characters_of(std::string_view listed) {
  constexpr std::string_view letters = "abfnrtv\\";
  constexpr std::string_view meant = "\a\b\f\n\r\t\v\\";
  std::vector<Listed> characters;
  while (!listed.empty()) {
    std::size_t n_read = 1;
    Listed next{listed.front(), false};
    if (next.character == '\\' && listed.size() > 1) {
      const auto letter = letters.find(listed[1]);
      unsigned byte = 0;
      const auto [end, error] = std::from_chars(
          listed.data() + 1, listed.data() + std::min<std::size_t>(4, listed.size()), byte, 8);
      if (letter != letters.npos) {
        next = {meant[letter], listed[1] != '\\'};
        n_read = 2;
      } else if (error == std::errc{}) {
        next = {static_cast<char>(byte), true};
        n_read = static_cast<std::size_t>(end - listed.data());
      }
    }
    characters.push_back(next);
    listed.remove_prefix(n_read);
  }
  return characters;
}

std::string name_of(const std::vector<Listed>& characters) {
  std::string name;
  for (const Listed& listed : characters) name += listed.character;
  return name;
}

/// A name as an argument of bsdtar, which takes it for a pattern. It could not convert a byte that
/// is no UTF-8, so that
/// `?`, any character, stands for what it escaped.
std::string pattern_of(const std::vector<Listed>& characters) {
  std::string pattern;
  for (const auto& [character, is_escaped] : characters) {
    const bool is_special = std::string_view("*?[]\\").find(character) != std::string_view::npos;
    if (is_special) pattern += '\\';
    pattern += is_escaped ? '?' : character;
  }
  return pattern;
}

bool leads_out(const std::string& name) {
  const fs::path path(name);
  return path.is_absolute() || std::ranges::find(path, fs::path("..")) != path.end();
}

}  // namespace

Archive::Archive(const Limits& limits, fs::path file, fs::path work, Isolation isolation)
    : limits_(limits), file_(std::move(file)), work_(std::move(work)), sandbox_(isolation, work_) {
  // The history of a repository, which is not read, may be in it.
  const int most_mb = 10 * limits.submission_mb;
  if (fs::file_size(file_) > static_cast<std::uintmax_t>(most_mb) * 1'048'576) {
    throw std::invalid_argument(fmt::format("the archive is larger than {} MB", most_mb));
  }
  list();
}

JobEnd Archive::run(const std::vector<std::string>& arguments, int file_kb) const {
  // The student chose the name of the archive. The copy has a fixed name, and every user may read
  // it.
  const fs::path copy = work_ / "archive";
  if (!fs::exists(copy)) {
    fs::copy_file(file_, copy);
    make_readable(copy);
  }
  const Readable archive{copy, "/archive"};
  Job job;
  job.command = {"/usr/bin/env", "LC_ALL=C.UTF-8", sys::find_tool("bsdtar")};
  job.command.insert(job.command.end(), arguments.begin(), arguments.end());
  // Without one, bsdtar would ask for the passphrase of a locked archive for ever.
  job.command.insert(job.command.begin() + 4, {sandbox_.place(archive), "--passphrase=none"});
  job.readable = {archive};
  job.output = work_ / "archive.out";
  job.errors = work_ / "archive.err";
  job.seconds = archive_seconds;
  job.memory_mb = limits_.memory_mb;
  job.processes = limits_.processes;
  job.file_kb = file_kb;
  return sandbox_.run(job);
}

void Archive::list() {
  const JobEnd end = run({"-tf"}, listing_kb);
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
    const std::vector<Listed> characters = characters_of(line);
    names_.push_back(name_of(characters));
    patterns_.push_back(pattern_of(characters));
    entries_.push_back(without_here(with_slashes(names_.back())));
  }
  if (entries_.empty()) throw std::invalid_argument("the archive is empty");
}

bool Archive::climbs_out() const {
  return std::ranges::any_of(names_, leads_out);
}

std::string Archive::read(const std::string& entry) const {
  const auto n_such = std::ranges::count(entries_, entry);
  if (n_such == 0) throw std::invalid_argument("is missing");
  if (n_such > 1) throw std::invalid_argument("is in the archive more than once");
  const auto at = std::ranges::find(entries_, entry) - entries_.begin();
  const std::string& pattern = patterns_[static_cast<std::size_t>(at)];
  if (std::ranges::count(patterns_, pattern) > 1) {
    throw std::invalid_argument("is in the archive more than once");
  }
  const JobEnd end = run({"-xOf", "--", pattern}, limits_.file_kb);
  if (end.ending == Ending::too_much_output) {
    throw std::invalid_argument(fmt::format("is larger than {} kB", limits_.file_kb));
  }
  if (end.ending == Ending::too_slow) throw std::invalid_argument("takes too long to unpack");
  if (end.ending != Ending::normal || end.status != 0) {
    throw std::invalid_argument("cannot be unpacked: the archive is damaged or locked");
  }
  const std::string text =
      beginning_of(work_ / "archive.out", static_cast<std::size_t>(limits_.file_kb) * 1024);
  if (text.empty()) throw std::invalid_argument("is empty, or not a file");
  return text;
}

}  // namespace course

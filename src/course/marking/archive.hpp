// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "course/assignment/assignment.hpp"
#include "course/sandbox/sandbox.hpp"

namespace course {

/// An archive that somebody else packed. bsdtar reads it in the sandbox, and writes single
/// entries to standard output; the archive is never unpacked. All reading after the list has one
/// limit of time.
class Archive {
 public:
  /// Lists the archive. Throws std::invalid_argument, with a line for the student, if it is too
  /// large or if bsdtar cannot read it within the limits.
  Archive(const Limits& limits, const std::filesystem::path& file, std::filesystem::path work,
          Isolation isolation, int unpacking_seconds = 10);

  /// The names in the archive, byte by byte, without a "./" in front and with slashes between their
  /// folders. Nobody promises that they are UTF-8.
  const std::vector<std::string>& entries() const { return entries_; }

  /// Whether there are entries with an absolute path, or with "..".
  bool climbs_out() const { return climbs_out_; }

  /// Puts aside all but these entries, as far as they are there, so that `read` need not go through
  /// the whole archive for each. A zip or a 7z stays as it is.
  void keep(const std::vector<std::string>& entries);

  /// The bytes of one entry. Throws std::invalid_argument whose message completes «file …».
  std::string read(const std::string& entry);

 private:
  JobEnd run(const std::vector<std::string>& arguments, int seconds, int file_kb) const;
  JobEnd unpack(const std::vector<std::string>& arguments, int file_kb);
  void list();

  Limits limits_;
  std::filesystem::path work_;
  Sandbox sandbox_;
  Readable copy_;  ///< under a fixed name, since the student chose that of the archive
  int unpacking_seconds_;
  double seconds_left_;
  std::vector<std::string> entries_;
  std::vector<std::string> patterns_;  ///< by which bsdtar finds them
  bool climbs_out_ = false;
};

}  // namespace course

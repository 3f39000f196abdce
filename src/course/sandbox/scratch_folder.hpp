// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "system/files.hpp"

namespace course {

/// The folder `above`/`name`-UID of this process's user, which is made if it does not exist.
/// Other users can reach files in it whose names they know, but cannot list it. Throws
/// sys::OutputError if something else has that name, such as a link or another user's folder.
std::filesystem::path private_folder(const std::filesystem::path& above, const std::string& name);

/// A new folder, which is removed with everything in it at the end of its scope. Folders that a
/// killed process left behind are removed when the next one is made. Submissions run as other
/// users, who can reach files in it whose names they know, but can list neither it nor the folder
/// that holds all of them. Throws sys::OutputError if no folder can be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  sys::Descriptor lock_;  ///< on the folder, as long as its owner lives
};

}  // namespace course

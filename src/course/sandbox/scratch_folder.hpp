// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "system/descriptor.hpp"

namespace course {

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

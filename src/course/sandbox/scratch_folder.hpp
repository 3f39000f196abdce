// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace course {

/// A fresh folder of its own, removed with what it holds at the end of its scope; what a killed
/// process left goes when the next one is made. Other users, as whom submissions run, may reach
/// what they know of in it, but list neither it nor the folder that all of them are in. Throws
/// sys::OutputError.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;  ///< on the folder, as long as its owner lives
};

}  // namespace course

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include "literate/error.hpp"

namespace course {

/// A fresh folder of its own, removed with what it holds at the end of its scope. Other users, as
/// whom submissions run, may reach what they know of in it, but not list it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "course.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw literate::OutputError("cannot make a scratch folder such as '" + name +
                                  "': " + std::generic_category().message(errno));
    }
    path_ = name;
    using std::filesystem::perms;
    std::filesystem::permissions(path_, perms::owner_all | perms::group_exec | perms::others_exec);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace course

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sys {

/// A new folder beside an output folder, in which the output is made before it is moved there.
///
/// Its name is that of the output folder with ".part" at the end. It is removed at the end of its
/// scope, so that a failure leaves the output folder as it was.
class Staging {
 public:
  /// Makes the folder, after removing one that a broken run left. What a run that was killed while
  /// it published had moved to the output folder is removed too, so look there for what is up to
  /// date only after this. Throws OutputError if either folder cannot be written, or if something
  /// else has the folder's name.
  explicit Staging(const std::filesystem::path& output_dir);
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// All files made so far, sorted, relative to path().
  std::vector<std::string> files() const;

  /// Moves the files to the output folder by renaming, except those whose content is the same
  /// there, and removes those of `former` that were not made again. Throws OutputError.
  void publish(const std::vector<std::string>& former);

  /// Does so and leaves no other file in the output folder.
  void replace();

 private:
  std::filesystem::path output_dir_;
  std::filesystem::path path_;
};

}  // namespace sys

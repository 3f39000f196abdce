// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/staging.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace sys {
namespace fs = std::filesystem;
namespace {

// This file distinguishes a folder that a broken run left from a folder of the user's own.
constexpr const char* marker = ".literate-staging";

fs::path without_trailing_slash(const fs::path& folder) {
  const fs::path normal = folder.lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

void require_writable(const fs::path& output_dir) {
  std::error_code error;
  fs::create_directories(output_dir, error);
  if (error || !fs::is_directory(output_dir) || ::access(output_dir.c_str(), W_OK | X_OK) != 0) {
    throw OutputError(fmt::format("cannot write to the output folder '{}'", output_dir.string()));
  }
}

// While the marker is written, it has the second name.
bool is_marker(const fs::path& file) {
  return file.filename() == marker || file.filename() == std::string(marker) + ".new";
}

bool is_marked(const fs::path& folder) {
  const fs::directory_iterator entries(folder);
  return fs::is_empty(folder) || std::any_of(begin(entries), end(entries),
                                             [](const auto& entry) { return is_marker(entry); });
}

// Removes the marker last, so that a run that is killed in here leaves a folder that is known.
void remove_marked(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!is_marker(entry)) files.push_back(entry);
  }
  for (const fs::path& file : files) fs::remove_all(file);
  fs::remove_all(folder);
}

void remove_stale(const fs::path& folder) {
  if (!fs::exists(fs::symlink_status(folder))) return;
  const bool is_folder = fs::is_directory(fs::symlink_status(folder));
  if (!is_folder || !is_marked(folder)) {
    throw OutputError(
        fmt::format("'{}' is needed as a staging folder but holds something else; move it away",
                    folder.string()));
  }
  remove_marked(folder);
}

bool is_below(const fs::path& file) {
  const fs::path normal = file.lexically_normal();
  return !normal.empty() && normal.is_relative() && *normal.begin() != "..";
}

// The list of all that a run is about to move into the output folder, or to remove from it.
fs::path list_of(const fs::path& output_dir) {
  fs::path list = output_dir;
  list += ".publishing";
  return list;
}

// Removes what a run that was killed while it published had moved already. Some of it may be whole
// and look up to date, but nothing tells which, and names that no later run makes would stay for
// ever.
void remove_half_published(const fs::path& output_dir) {
  const fs::path list = list_of(output_dir);
  if (!fs::is_regular_file(list)) return;
  const std::string text = read_file(list);
  for (const std::string_view file : lines_of(text)) {
    if (is_below(file) && fs::is_regular_file(output_dir / file)) fs::remove(output_dir / file);
  }
  fs::remove(list);
}

}  // namespace

Staging::Staging(const fs::path& output_dir)
    : output_dir_(without_trailing_slash(output_dir)), path_(output_dir_) {
  path_ += ".part";
  try {
    require_writable(output_dir_);
    remove_half_published(output_dir_);
    remove_stale(path_);
    fs::create_directory(path_);
    write_file_atomically(path_ / marker, "");
  } catch (const fs::filesystem_error& error) {
    throw OutputError(fmt::format("cannot make the staging folder '{}': {}", path_.string(),
                                  error.code().message()));
  }
}

Staging::~Staging() {
  try {
    remove_marked(path_);
  } catch (const fs::filesystem_error&) {
    // What is left is removed by the next run.
  }
}

std::vector<std::string> Staging::files() const {
  std::vector<std::string> files = files_below(path_);
  std::erase(files, marker);
  return files;
}

void Staging::publish(const std::vector<std::string>& former) {
  const std::vector<std::string> made = files();
  const fs::path list = list_of(output_dir_);
  try {
    // Find all that changes before changing anything. What is there already with the same bytes is
    // nobody's to remove: draw has copies of what compute wrote.
    std::vector<std::string> changed;
    for (const std::string& file : made) {
      const fs::path place = output_dir_ / file;
      if (!fs::is_regular_file(place) || read_file(place) != read_file(path_ / file)) {
        changed.push_back(file);
      }
    }
    std::string own;
    for (const std::string& file : changed) own += file + "\n";
    for (const std::string& file : former) {
      if (!std::ranges::binary_search(made, file)) own += file + "\n";
    }
    write_file_atomically(list, own);
    for (const std::string& file : changed) {
      fs::create_directories((output_dir_ / file).parent_path());
      fs::rename(path_ / file, output_dir_ / file);
    }
    for (const std::string& file : former) {
      if (is_below(file) && !std::ranges::binary_search(made, file)) fs::remove(output_dir_ / file);
    }
    fs::remove(list);
  } catch (const fs::filesystem_error& error) {
    const fs::path& file = error.path2().empty() ? error.path1() : error.path2();
    throw OutputError(fmt::format("cannot write to the output folder '{}': {}: {}",
                                  output_dir_.string(), file.string(), error.code().message()));
  }
}

void Staging::replace() {
  publish(files_below(output_dir_));
}

}  // namespace sys

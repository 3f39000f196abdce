// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/assignment/student.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "course/assignment/student_text.hpp"
#include "system/ascii.hpp"
#include "system/error.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 9> endings = {
    ".zip", ".7z", ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tbz2", ".tar.xz", ".tar.zst"};

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Some systems write the ending in capitals.
std::string_view ending_of(std::string_view name) {
  const auto* ending = std::ranges::find_if(endings, [&](std::string_view end) {
    return name.size() >= end.size() &&
           std::ranges::equal(name.substr(name.size() - end.size()), end, {}, lower);
  });
  return ending == endings.end() ? std::string_view{} : *ending;
}

bool is_id_character(char c) {
  return sys::is_alphanumeric(c) || c == '.' || c == '_' || c == '-' || c == '@';
}

}  // namespace

void require_student_id(const std::string& student) {
  const bool is_plain = std::ranges::all_of(student, is_id_character);
  const bool begins_ill = student.find_first_of(".-@") == 0;
  const bool ends_ill = student.ends_with(".part") || names_archive(student);
  if (!student.empty() && student.size() <= 64 && is_plain && !begins_ill && !ends_ill) return;
  throw sys::SourceError(fmt::format(
      "student \"{}\": an id consists of 1 to 64 letters, digits, '.', '_', '-' and '@', does not "
      "begin with '.', '-' or '@' and does not end with .part, .zip or another archive's ending",
      shown_name(student)));
}

std::string archive_endings() {
  return fmt::format("{}", fmt::join(endings, ", "));
}

bool names_archive(const fs::path& path) {
  return !ending_of(path.filename().string()).empty();
}

std::string student_of(const fs::path& path) {
  fs::path clean = fs::absolute(path).lexically_normal();
  if (!clean.has_filename()) clean = clean.parent_path();
  const std::string name = clean.filename().string();
  if (fs::is_directory(fs::symlink_status(path))) return name;
  return name.substr(0, name.size() - ending_of(name).size());
}

}  // namespace course

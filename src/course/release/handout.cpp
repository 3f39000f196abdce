// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/handout.hpp"

#include <fmt/core.h>

#include "system/error.hpp"
#include "system/files.hpp"
#include "system/staging.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr fs::perms executable =
    fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;

// Binary files are copied as they are.
MarkedText marked(const Assignment& assignment, const fs::path& file) {
  const std::string text = sys::read_file(file);
  if (text.find('\0') != std::string::npos) {
    return {.handout = text, .solution = text, .secrets = {}, .hidden_regions = {}};
  }
  MarkedText marked = apply_markers(text, file.string());
  // The lists of the file as it stands are tried first, since only there a fault's line is the
  // author's own.
  with_lists(assignment, text, file.string());
  marked.handout = with_lists(assignment, marked.handout, file.string());
  marked.solution = with_lists(assignment, marked.solution, file.string());
  return marked;
}

ProjectFile read(const Assignment& assignment, const fs::path& file) {
  return {.origin = file,
          .text = marked(assignment, file),
          .permissions = fs::status(file).permissions()};
}

// A folder that holds the file of the variant was written by this program and may be replaced.
void require_replaceable(const fs::path& folder) {
  if (fs::is_empty(folder) || fs::is_regular_file(folder / variant_file)) return;
  throw sys::OutputError(
      fmt::format("'{}' exists and was not written by this command; name another folder or "
                  "remove it",
                  folder.string()));
}

void write(const fs::path& file, const std::string& text, fs::perms permissions) {
  sys::write_file_atomically(file, text);
  if ((permissions & fs::perms::owner_exec) != fs::perms::none) {
    fs::permissions(file, executable, fs::perm_options::add);
  }
}

}  // namespace

Project read_project(const Assignment& assignment, const fs::path& source) {
  const fs::path from = assignment.folder / "template";
  if (fs::exists(from / "build")) {
    throw sys::SourceError(
        fmt::format("{}: somebody has compiled in the template; remove this folder",
                    (from / "build").string()));
  }
  Project project;
  for (const std::string& file : sys::files_below(from))
    project[file] = read(assignment, from / file);
  for (const std::string& file : assignment.provided) {
    const auto fail = [&](const std::string& what) {
      throw sys::SourceError(
          fmt::format("{}: provided: {}", (assignment.folder / "assignment.toml").string(), what));
    };
    const fs::path origin = source / "src" / file;
    if (!fs::is_regular_file(origin)) fail(fmt::format("there is no src/{}", file));
    const auto [entry, is_new] = project.try_emplace("provided/" + file, read(assignment, origin));
    if (!is_new) fail(fmt::format("template/provided/{} exists as well", file));
  }
  if (project.contains(variant_file) || project.contains("sheet.pdf")) {
    throw sys::SourceError(
        fmt::format("{}: {} and sheet.pdf are made for each handout", from.string(), variant_file));
  }
  return project;
}

Files texts(const Project& project, Edition edition) {
  Files files;
  for (const auto& [name, file] : project) {
    files[name] = edition == Edition::handout ? file.text.handout : file.text.solution;
  }
  return files;
}

Files submission(const Assignment& assignment, const Files& files) {
  Files submitted;
  for (const Exercise& exercise : assignment.exercises) {
    submitted[exercise.file] = files.at(exercise.file);
    if (!exercise.tests.empty()) submitted[exercise.tests] = files.at(exercise.tests);
  }
  return submitted;
}

std::string variant_header(const Assignment& assignment, const Variant& variant) {
  std::string entries;
  for (const Quantity& quantity : assignment.quantities) {
    entries +=
        fmt::format("        {{\"{}\", {:#}}},  // {}\n", quantity.name, variant(quantity.name),
                    quantity.unit.empty() ? "a pure number" : quantity.unit);
  }
  return fmt::format(
      "// These are the numbers of this handout. Each student has others.\n"
      "#pragma once\n"
      "\n"
      "#include \"course/assignment/variant.hpp\"\n"
      "\n"
      "inline const course::Variant this_variant{{\n"
      "    \"{}\",\n"
      "    {{\n"
      "{}"
      "    }},\n"
      "}};\n",
      variant.student, entries);
}

void write_project(const Project& project, Edition edition, const Assignment& assignment,
                   const Variant& variant, const fs::path& sheet, const fs::path& output) {
  sys::Staging staging(output);
  require_replaceable(output);
  write(staging.path() / variant_file, variant_header(assignment, variant), fs::perms::none);
  for (const auto& [name, text] : texts(project, edition)) {
    write(staging.path() / name, text, project.at(name).permissions);
  }
  if (!sheet.empty()) {
    write(staging.path() / "sheet.pdf", sys::read_file(sheet), fs::perms::none);
  }
  staging.replace();
}

}  // namespace course

// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/toolkit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "course/assignment/variants.hpp"
#include "course/release/handout.hpp"
#include "course/sandbox/sandbox.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"
#include "system/process.hpp"
#include "system/staging.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr const char* header = "precompiled.hpp";
constexpr const char* list_of_files = "files.txt";

bool is_exercise(const Assignment& assignment, const std::string& file) {
  return std::ranges::find(assignment.exercises, file, &Exercise::file) !=
         assignment.exercises.end();
}

/// Writes src/ and provided/ of the handout; returns their paths.
std::set<std::string> write_project(const Assignment& assignment, const fs::path& source,
                                    const fs::path& folder) {
  std::set<std::string> files;
  Files handout = texts(read_project(assignment, source), Edition::handout);
  handout["provided/variant_of_this_handout.hpp"] =
      variant_header(assignment, nominal_variant(assignment));
  for (const auto& [file, text] : handout) {
    if (!file.starts_with("src/") && !file.starts_with("provided/")) continue;
    sys::write_file_atomically(folder / file, text);
    files.insert(file);
  }
  return files;
}

/// All library headers that the project includes, the standard ones that students will, and no
/// more: a header that a file does not include must not turn its own names ambiguous.
std::string header_text(const fs::path& project, const std::set<std::string>& files) {
  std::set<std::string> headers = {"<algorithm>", "<array>",   "<cmath>",     "<functional>",
                                   "<limits>",    "<numbers>", "<stdexcept>", "<string>",
                                   "<utility>",   "<vector>"};
  for (const std::string& file : files) {
    const std::string text = sys::read_file(project / file);
    for (const std::string_view line : sys::lines_of(text)) {
      constexpr std::string_view include = "#include <";
      if (line.starts_with(include)) {
        headers.emplace(line.substr(include.size() - 1, line.find('>') - include.size() + 2));
      }
    }
  }
  std::string text;
  for (const std::string& name : headers) {
    text += fmt::format("#if __has_include({0})\n#include {0}\n#endif\n", name);
  }
  return text;
}

void compile(std::vector<std::string> arguments, const fs::path& product) {
  fs::create_directories(product.parent_path());
  arguments.insert(arguments.end(), {"-o", product.string()});
  const sys::ProcessResult result = sys::run(
      {.program = "g++", .arguments = std::move(arguments), .environment = {{"LC_ALL", "C"}}});
  if (result.exit_status != 0) {
    throw sys::ToolError(fmt::format("the toolkit does not compile: g++ says\n{}", result.output));
  }
}

void make_header(const fs::path& folder, const std::set<std::string>& files) {
  sys::write_file_atomically(folder / header, header_text(folder / "project", files));
  std::vector<std::string> arguments = compile_flags((folder / "project").string());
  arguments.insert(arguments.end(), {"-x", "c++-header", (folder / header).string()});
  compile(arguments, folder / (std::string(header) + ".gch"));
}

/// What is given goes into an archive, but for main(): so a second program among it does no harm.
void archive(const fs::path& folder) {
  sys::Command command{.program = "ar", .arguments = {"rcD", Toolkit{folder}.archive().string()}};
  for (const std::string& file : sys::files_below(folder / "objects")) {
    const fs::path object = folder / "objects" / file;
    if (object != Toolkit{folder}.main_object()) command.arguments.push_back(object.string());
  }
  const sys::ProcessResult result = sys::run(command);
  if (result.exit_status != 0) {
    throw sys::ToolError(fmt::format("the toolkit cannot be made: ar says {}", result.output));
  }
}

void compile_all(const Assignment& assignment, const fs::path& folder,
                 const std::set<std::string>& files) {
  const fs::path project = folder / "project";
  make_header(folder, files);
  for (const std::string& file : files) {
    if (!file.ends_with(".cpp")) continue;
    std::vector<std::string> arguments = compile_flags(project.string());
    arguments.insert(arguments.end(),
                     {"-include", (folder / header).string(), "-c", (project / file).string()});
    const char* kind = is_exercise(assignment, file) ? "stubs" : "objects";
    compile(arguments, folder / kind / (file + ".o"));
  }
  archive(folder);
}

}  // namespace

fs::path Toolkit::stub_of(const Exercise& exercise) const {
  return folder / "stubs" / (exercise.file + ".o");
}

std::vector<std::string> compile_flags(const std::string& project) {
  return {"-std=c++20",
          "-O2",
          "-w",
          "-I",
          project + "/provided",
          "-I",
          project + "/src",
          "-isystem",
          "/usr/include/eigen3"};
}

std::vector<std::string> link_flags() {
  return {"-Wl,--as-needed", "-lgsl", "-lgslcblas", "-lfmt", "-lm"};
}

void make_toolkit(const Assignment& assignment, const fs::path& source, const fs::path& output) {
  std::vector<std::string> former;
  if (fs::exists(output / list_of_files)) {
    const std::string list = sys::read_file(output / list_of_files);
    for (const std::string_view file : sys::lines_of(list)) former.emplace_back(file);
  } else if (fs::exists(output) && !fs::is_empty(output)) {
    throw sys::OutputError(fmt::format(
        "'{}' is no toolkit but holds something; name another folder", output.string()));
  }
  sys::Staging staging(output);
  compile_all(assignment, staging.path(),
              write_project(assignment, source, staging.path() / "project"));
  std::string list;
  for (const std::string& file : staging.files()) list += file + "\n";
  sys::write_file_atomically(staging.path() / list_of_files, list);
  make_readable(staging.path());
  staging.publish(former);
  make_readable(output);
}

Toolkit open_toolkit(const Assignment& assignment, const fs::path& folder) {
  Toolkit toolkit{fs::absolute(folder)};
  if (!fs::exists(folder / list_of_files)) {
    throw sys::OutputError(
        fmt::format("'{}' is no toolkit; `halfspace-course toolkit` makes one", folder.string()));
  }
  for (const Exercise& exercise : assignment.exercises) {
    if (!fs::exists(toolkit.stub_of(exercise))) {
      throw sys::OutputError(
          fmt::format("the toolkit '{}' is of another assignment: it has no stub of {}",
                      folder.string(), exercise.file));
    }
  }
  return toolkit;
}

}  // namespace course

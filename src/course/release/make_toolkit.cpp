// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/release/make_toolkit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "course/marking/toolkit.hpp"
#include "course/release/handout.hpp"
#include "course/sandbox/sandbox.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "system/staging.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// Whether students write a file.
bool is_theirs(const Assignment& assignment, const std::string& file) {
  return std::ranges::any_of(assignment.exercises, [&](const Exercise& exercise) {
    return file == exercise.file || file == exercise.tests;
  });
}

/// Writes src/, provided/ and report/ of the handout; returns the paths of the files that are
/// compiled once: what is below report/ is compiled with each student's own numbers.
std::set<std::string> write_project(const Assignment& assignment, const Project& project,
                                    const fs::path& folder) {
  std::set<std::string> files;
  Files handout = texts(project, Edition::handout);
  handout[variant_file] = variant_header(assignment, nominal_variant(assignment));
  for (const auto& [file, text] : handout) {
    const bool is_of_report = file.starts_with("report/");
    if (!is_of_report && !file.starts_with("src/") && !file.starts_with("provided/")) continue;
    sys::write_file_atomically(folder / file, text);
    if (!is_of_report) files.insert(file);
  }
  return files;
}

/// Includes all library headers that the project includes and the standard ones that students
/// are likely to include, but no others: their names could clash with those in a student's file.
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

void make_header(const Toolkit& toolkit, const std::set<std::string>& files) {
  const std::string header = toolkit.header().string();
  sys::write_file_atomically(header, header_text(toolkit.project(), files));
  std::vector<std::string> arguments = compile_flags(toolkit.project().string());
  arguments.insert(arguments.end(), {"-x", "c++-header", header});
  run_compiler(arguments, header + ".gch");
}

/// Puts the given objects into an archive, except the one with main(), so that the linker takes
/// only those that a program needs.
void archive(const Toolkit& toolkit) {
  sys::Command command{.program = "ar", .arguments = {"rcD", toolkit.archive().string()}};
  const fs::path objects = toolkit.folder / "objects";
  for (const std::string& file : sys::files_below(objects)) {
    if (objects / file == toolkit.main_object()) continue;
    command.arguments.push_back((objects / file).string());
  }
  const sys::ProcessResult result = sys::run(command);
  if (result.exit_status != 0) {
    throw sys::ToolError(fmt::format("the toolkit cannot be made: ar says {}", result.output));
  }
}

void compile_all(const Assignment& assignment, const Toolkit& toolkit,
                 const std::set<std::string>& files) {
  make_header(toolkit, files);
  for (const std::string& file : files) {
    if (!file.ends_with(".cpp")) continue;
    const char* kind = is_theirs(assignment, file) ? "stubs" : "objects";
    compile(toolkit, toolkit.project() / file, toolkit.folder / kind / (file + ".o"));
  }
  archive(toolkit);
}

}  // namespace

void run_compiler(std::vector<std::string> arguments, const std::filesystem::path& product) {
  std::filesystem::create_directories(product.parent_path());
  arguments.insert(arguments.end(), {"-o", product.string()});
  const sys::ProcessResult result = sys::run(
      {.program = "g++", .arguments = std::move(arguments), .environment = {{"LC_ALL", "C"}}});
  if (result.exit_status != 0) {
    throw sys::ToolError(fmt::format("the toolkit does not compile: g++ says\n{}", result.output));
  }
}

void compile(const Toolkit& toolkit, const fs::path& source, const fs::path& object) {
  std::vector<std::string> arguments = compile_flags(toolkit.project().string());
  arguments.insert(arguments.end(), {"-include", toolkit.header().string(), "-c", source.string()});
  run_compiler(std::move(arguments), object);
}

void make_toolkit(const Assignment& assignment, const fs::path& source, const fs::path& output) {
  const bool may_be_replaced =
      !fs::exists(output) || fs::is_empty(output) || fs::exists(Toolkit{output}.header());
  if (!may_be_replaced) {
    throw sys::OutputError(fmt::format(
        "'{}' is no toolkit but holds something; name another folder", output.string()));
  }
  sys::Staging staging(output);
  const Toolkit toolkit{staging.path()};
  const Project project = read_project(assignment, source);
  compile_all(assignment, toolkit, write_project(assignment, project, toolkit.project()));
  make_readable(staging.path());
  staging.replace();
  make_readable(output);
  make_programs(assignment, Toolkit{output}, texts(project, Edition::solution));
}

}  // namespace course

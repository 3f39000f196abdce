// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/compiler.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/erase.hpp>
#include <string_view>

#include "course/assignment/student.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t max_message = 4000;  ///< bytes that a student is shown
constexpr int max_object_kb = 64 * 1024;

/// A compiler's message with at most three lines «from …» in a row, which say what included
/// what, so that the error itself is not cut off.
std::string without_long_chains(const std::string& text) {
  std::string result;
  int n_in_a_row = 0;
  for (const std::string_view line : sys::lines_of(text)) {
    n_in_a_row = line.starts_with("                 from ") ? n_in_a_row + 1 : 0;
    if (n_in_a_row > 3) continue;
    result += line;
    result += '\n';
  }
  return result;
}

/// Whether a file may change what the headers mean that it includes: then none may stand before its
/// own text, or `#define NDEBUG` and the like would have no effect. It looks for words, and takes a
/// comment with one of them for a directive, which costs time and nothing else.
bool changes_its_headers(std::string_view text) {
  const std::string_view before = text.substr(0, std::min(text.rfind("include"), text.size()));
  return std::ranges::any_of(std::array{"define", "undef", "ragma"}, [&](std::string_view word) {
    return before.find(word) != before.npos;
  });
}

bool has_worked(const JobEnd& end) {
  return end.ending == Ending::normal && end.status == 0;
}

}  // namespace

Compiler::Compiler(const Assignment& assignment, const fs::path& toolkit, const fs::path& scratch,
                   Isolation isolation)
    : toolkit_(open_toolkit(assignment, toolkit)),
      limits_(assignment.limits),
      scratch_(scratch),
      sandbox_(isolation, scratch),
      given_{toolkit_.folder, "/toolkit"},
      project_{scratch / "project", "/project"} {
  require_readable_toolkit();
}

void Compiler::write_project(const Assignment& assignment, const Files& files) const {
  fs::copy(toolkit_.project(), project_.path, fs::copy_options::recursive);
  for (const Exercise& exercise : assignment.exercises) {
    for (const std::string& name : {exercise.file, exercise.tests}) {
      const auto file = files.find(name);
      if (file != files.end()) sys::write_file_atomically(project_.path / name, file->second);
    }
  }
  make_readable(project_.path);
}

void Compiler::use(const OtherMain& other) {
  for (const auto& [file, text] : other.files) {
    sys::write_file_atomically(project_.path / file, text);
  }
  make_readable(project_.path);
  const Readable object{scratch_ / "main.o", "/main.o"};
  const std::string error = compile(other.file, object.path);
  if (!error.empty()) {
    throw sys::ToolError(fmt::format("{} of the handout does not compile: {}", other.file, error));
  }
  other_main_ = object;
}

std::string Compiler::compile(const std::string& file, const fs::path& object) const {
  if (seconds_ > seconds_for_all()) {
    return fmt::format("all files together take longer than {} s to compile", seconds_for_all());
  }
  if (changes_its_headers(sys::read_file(project_.path / file))) {
    return message_of(run(arguments_for(file, false), object));
  }
  const JobEnd end = run(arguments_for(file, true), object);
  if (has_worked(end)) return "";
  std::string excess = excess_of(end);
  if (!excess.empty()) return excess;
  // The precompiled header may declare a name that the file uses for something else.
  return message_of(run(arguments_for(file, false), object));
}

bool Compiler::are_complete(const std::vector<Readable>& objects) const {
  std::vector<std::string> arguments = {"-Wl,--defsym=main=0"};
  add_what_is_linked(objects, arguments);
  return has_worked(run(arguments, scratch_ / "complete", objects));
}

std::string Compiler::link(const std::vector<Readable>& objects, const fs::path& program) const {
  std::vector<Readable> readable = objects;
  if (other_main_) readable.push_back(*other_main_);
  std::vector<std::string> arguments;
  if (!other_main_) arguments.push_back(in_sandbox(toolkit_.main_object()));
  add_what_is_linked(readable, arguments);
  return message_of(run(arguments, program, readable));
}

void Compiler::require_readable_toolkit() const {
  Job job;
  job.command = {"/usr/bin/test", "-r", in_sandbox(toolkit_.header())};
  job.readable = {given_};
  job.output = scratch_ / "compiler.out";
  job.errors = errors();
  job.seconds = 60;  // far more than it takes, for a busy machine
  const JobEnd end = sandbox_.run(job);
  if (end.ending != Ending::normal) {
    throw sys::ToolError(
        "a program that does nothing was ended in the sandbox; is the machine too busy?");
  }
  if (end.status == 0) return;
  throw sys::ToolError(fmt::format(
      "the toolkit '{}' is not readable to other users, as whom submissions are compiled",
      toolkit_.folder.string()));
}

/// The path by which a job finds a file of the toolkit.
std::string Compiler::in_sandbox(const fs::path& file) const {
  return sandbox_.place(given_) + "/" + file.lexically_relative(toolkit_.folder).string();
}

void Compiler::add_what_is_linked(const std::vector<Readable>& objects,
                                  std::vector<std::string>& arguments) const {
  for (const Readable& object : objects) arguments.push_back(sandbox_.place(object));
  arguments.push_back(in_sandbox(toolkit_.archive()));
  for (const std::string& flag : link_flags()) arguments.push_back(flag);
}

std::vector<std::string> Compiler::arguments_for(const std::string& file,
                                                 bool is_precompiled) const {
  std::vector<std::string> arguments = compile_flags(sandbox_.place(project_));
  for (const char* flag : {"-fmax-errors=10", "-ftemplate-backtrace-limit=4", "-pipe", "-c"}) {
    arguments.emplace_back(flag);
  }
  if (is_precompiled) {
    arguments.emplace_back("-include");
    arguments.push_back(in_sandbox(toolkit_.header()));
  }
  arguments.push_back(file);
  return arguments;
}

/// Runs g++. The product is written to standard output, so that the job needs no writable
/// folder outside.
JobEnd Compiler::run(const std::vector<std::string>& arguments, const fs::path& product,
                     const std::vector<Readable>& objects) const {
  if (seconds_ > limits_.submission_seconds) return {.ending = Ending::too_slow};
  Job job;
  job.command = {"/bin/sh", "-c", R"(out=$1; shift; g++ "$@" -o "$out" || exit; cat "$out")", "sh",
                 sandbox_.scratch() + "/out"};
  job.command.insert(job.command.end(), arguments.begin(), arguments.end());
  job.readable = {given_, project_};
  job.readable.insert(job.readable.end(), objects.begin(), objects.end());
  job.folder = sandbox_.place(project_);
  job.output = product;
  job.errors = errors();
  job.seconds = seconds_for_one();
  // A compiler that waits longer reads from something that gives it nothing.
  job.waiting_seconds = 10;
  job.memory_mb = limits_.memory_mb;
  job.processes = limits_.processes;
  job.file_kb = max_object_kb;
  job.scratch_mb = 2 * max_object_kb / 1024;
  const JobEnd end = sandbox_.run(job);
  seconds_ += end.seconds;
  make_readable(product);
  return end;
}

int Compiler::seconds_for_all() const {
  return std::max(1, limits_.submission_seconds / 2);
}

/// What a compilation or the linker may take of what is left for all of them; enough for an
/// honest program to be linked in any case.
int Compiler::seconds_for_one() const {
  constexpr int least = 5;
  const int left = seconds_for_all() - static_cast<int>(seconds_);
  return std::min(limits_.compile_seconds, std::max(least, left));
}

fs::path Compiler::errors() const {
  return scratch_ / "compiler.err";
}

/// Which limit was exceeded; empty if none was.
std::string Compiler::excess_of(const JobEnd& end) const {
  const std::string text = beginning_of(errors(), 16 * max_message);
  const auto says = [&](const char* words) { return text.find(words) != std::string::npos; };
  if (end.ending == Ending::too_slow || says("CPU time limit exceeded") ||
      says("Killed signal terminated")) {
    return fmt::format("it takes longer than {} s to compile", limits_.compile_seconds);
  }
  if (end.ending != Ending::normal || text.empty()) return too_large();
  // These are messages of g++ when it runs out of memory. Their texts depend on chance, so the
  // student is told the limit instead.
  for (const char* words :
       {"out of memory", "virtual memory", "cannot allocate", "Cannot allocate", "fatal signal",
        "internal compiler error", "memory exhausted", "signal terminated program", "ile too large",
        "No space left", "File size limit"}) {
    if (says(words)) return too_large();
  }
  return "";
}

std::string Compiler::message_of(const JobEnd& end) const {
  if (has_worked(end)) return "";
  std::string excess = excess_of(end);
  if (!excess.empty()) return excess;
  std::string text = without_long_chains(beginning_of(errors(), 16 * max_message));
  for (const fs::path& folder : {project_.path, toolkit_.folder, scratch_}) {
    boost::algorithm::erase_all(text, folder.string() + "/");
  }
  const bool misses_a_header = text.find("No such file or directory\n") != text.npos &&
                               text.find("#include \"") != text.npos;
  const std::string hint =
      misses_a_header ? "Only the exercises' own files are taken from a submission: what stands in "
                        "another file must stand in them.\n"
                      : "";
  return shown(text, max_message) + hint;
}

std::string Compiler::too_large() const {
  return fmt::format("it takes more than {} MB of memory to compile, or gives more than {} MB",
                     limits_.memory_mb, max_object_kb / 1024);
}

}  // namespace course

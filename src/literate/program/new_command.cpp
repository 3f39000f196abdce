// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "command_line/options.hpp"
#include "literate/main/paper.hpp"
#include "literate/program/commands.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"
#include "system/process.hpp"
#include "system/staging.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// What the template calls its paper: in the names of its files, and in their text.
constexpr std::string_view template_name = "mypaper";

/// What the template calls the engine's commit, to which its workflows hold.
constexpr std::string_view template_commit = "myenginecommit";

struct NewOptions {
  std::string folder, name;
};

/// Where the template lies, as seen from this program: an installed one, or one in a build folder.
fs::path template_folder() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "share/literate-" LITERATE_VERSION "/template";
}

std::string replaced(std::string text, std::string_view from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string with_name(std::string text, const std::string& name) {
  return replaced(std::move(text), template_name, name);
}

/// The commit that the engine was installed from, or that of its checkout; unknown without git.
std::string engine_commit() {
  const fs::path engine = fs::canonical(template_folder().parent_path());
  if (fs::is_regular_file(engine / "repository.json")) return read_repository(engine).commit;
  const std::string checkout = engine.parent_path().parent_path().string();
  try {
    const sys::ProcessResult said = sys::run(
        {"git",
         {"-c", "safe.directory=" + checkout, "-C", checkout, "rev-parse", "--short=12", "HEAD"}});
    if (said.exit_status == 0) return std::string(sys::stripped(said.output));
  } catch (const sys::ToolError&) {
    // Whoever has no git has no workflow either.
  }
  return "unknown";
}

void require_empty(const fs::path& folder, const std::string& as_given) {
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder))) {
    throw sys::InputError(fmt::format("'{}' exists and is not empty", as_given));
  }
}

/// The name becomes that of a CMake target, of a LaTeX file and of a program. literate_add_paper
/// refuses the same names.
void require_paper_name(const std::string& name) {
  static const std::set<std::string> taken = {"all",        "clean",
                                              "depend",     "edit_cache",
                                              "help",       "install",
                                              "literate",   "none",
                                              "package",    "package_source",
                                              "test",       "rebuild_cache",
                                              "preinstall", "list_install_components"};
  if (taken.contains(name)) {
    throw sys::InputError(fmt::format(
        "'{}' cannot name a paper: CMake has a target of this name; give another --name", name));
  }
  if (sys::Pattern("[A-Za-z][A-Za-z0-9_-]*").is_all_of(name)) return;
  throw sys::InputError(fmt::format(
      "'{}' cannot name a paper: a letter, then letters, digits, '-' and '_'; give another --name",
      name));
}

command_line::ExitCode run(const NewOptions& options) {
  const fs::path folder = fs::absolute(options.folder + "/").lexically_normal().parent_path();
  const std::string name = options.name.empty() ? folder.filename().string() : options.name;
  require_empty(folder, options.folder);
  require_paper_name(name);

  const fs::path from = template_folder();
  const std::string commit = engine_commit();
  sys::Staging staging(folder);
  for (const std::string& file : sys::files_below(from)) {
    sys::write_file_atomically(
        staging.path() / with_name(file, name),
        replaced(with_name(sys::read_file(from / file), name), template_commit, commit));
  }
  staging.publish({});
  fmt::print("{}: cd there and run make\n", options.folder);
  return command_line::ExitCode::success;
}

}  // namespace

void add_new_command(CLI::App& program, sys::ExitCode& exit_code) {
  using namespace command_line;
  add_command(program, "new", "Write a paper of one's own, which builds at once, to a new folder",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<NewOptions>();
                add_required_text(command, "folder", options->folder, "DIR",
                                  "The folder, which is made");
                add_text(command, "--name", options->name, "NAME",
                         "What the paper is called, if not as its folder");
                return [options] { return run(*options); };
              });
}

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "command_line/options.hpp"
#include "literate/program/commands.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"
#include "system/staging.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

/// What the template calls its paper: in the names of its files, and in their text.
constexpr std::string_view template_name = "mypaper";

struct NewOptions {
  std::string folder, name;
};

/// Where the template lies, as seen from this program: an installed one, or one in a build folder.
fs::path template_folder() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "share/literate-" LITERATE_VERSION "/template";
}

std::string with_name(std::string text, const std::string& name) {
  for (auto at = text.find(template_name); at != std::string::npos;
       at = text.find(template_name, at + name.size())) {
    text.replace(at, template_name.size(), name);
  }
  return text;
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
  sys::Staging staging(folder);
  for (const std::string& file : sys::files_below(from)) {
    sys::write_file_atomically(staging.path() / with_name(file, name),
                               with_name(sys::read_file(from / file), name));
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

// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "course/release/make_toolkit.hpp"
#include "course/release/wrong_solutions.hpp"
#include "course/sandbox/scratch_folder.hpp"
#include "system/error.hpp"
#include "system/files.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// Compiles the programs on which the tests of one exercise are tried: the solution, and the wrong
/// solutions of its file.
class Programs {
 public:
  Programs(const Assignment& assignment, const Exercise& exercise, const Toolkit& toolkit,
           const Files& solution, const fs::path& folder)
      : exercise_(exercise), toolkit_(toolkit), folder_(folder) {
    for (const Exercise& each : assignment.exercises) {
      objects_[each.file] = toolkit.stub_of(each.file);
    }
    for (const std::string& file : files_behind(assignment, exercise)) {
      if (file != exercise.file) objects_[file] = object_of(file, solution.at(file));
    }
  }

  /// The program with this text as the exercise's own file.
  void make(const std::string& text, const std::string& name) {
    objects_[exercise_.file] = object_of(exercise_.file, text);
    std::vector<std::string> arguments = {toolkit_.main_object().string()};
    for (const auto& [file, object] : objects_) arguments.push_back(object.string());
    arguments.push_back(toolkit_.archive().string());
    for (const std::string& flag : link_flags()) arguments.push_back(flag);
    run_compiler(arguments, folder_ / name);
  }

 private:
  fs::path object_of(const std::string& file, const std::string& text) {
    const fs::path source = scratch_.path() / file;
    sys::write_file_atomically(source, text);
    fs::path object = source;
    object += ".o";
    compile(toolkit_, source, object);
    return object;
  }

  const Exercise& exercise_;
  const Toolkit& toolkit_;
  fs::path folder_;
  ScratchFolder scratch_;
  std::map<std::string, fs::path> objects_;
};

void make_programs_of(const Assignment& assignment, const Exercise& exercise,
                      const Toolkit& toolkit, const Files& solution) {
  const fs::path folder = toolkit.programs_of(exercise.id);
  fs::remove(folder / "right");
  fs::remove_all(folder / "wrong");
  Programs programs(assignment, exercise, toolkit, solution, folder);
  int n_wrong = 0;
  for (const WrongSolution& wrong : read_wrong_solutions(assignment, solution)) {
    if (std::ranges::find(wrong.changes, exercise.file, &Change::file) == wrong.changes.end()) {
      continue;
    }
    programs.make(with_mistake(solution, wrong).at(exercise.file), "wrong/" + wrong.id);
    ++n_wrong;
  }
  if (n_wrong == 0) {
    throw sys::SourceError(fmt::format(
        "{}: no wrong solution changes {}, on which {} could be tried",
        (assignment.folder / "wrong_solutions.toml").string(), exercise.file, exercise.tests));
  }
  programs.make(solution.at(exercise.file), "right");
}

}  // namespace

void make_programs(const Assignment& assignment, const Toolkit& toolkit, const Files& solution) {
  for (const Exercise& exercise : assignment.exercises) {
    if (exercise.tests.empty()) continue;
    const fs::path folder = toolkit.programs_of(exercise.id);
    fs::create_directories(folder);
    fs::permissions(folder.parent_path(), fs::perms::owner_all);
    make_programs_of(assignment, exercise, toolkit, solution);
  }
}

}  // namespace course

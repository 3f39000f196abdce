// SPDX-License-Identifier: GPL-3.0-or-later
#include "course/marking/build.hpp"

#include <fmt/core.h>

#include <utility>

#include "system/files.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// The files of a submission as objects, with stubs for those that do not compile.
class Objects {
 public:
  Objects(const Assignment& assignment, const Compiler& compiler, fs::path folder)
      : assignment_(assignment), compiler_(compiler), folder_(std::move(folder)) {
    fs::create_directories(folder_);
  }

  void compile(const Files& files) {
    for (const Exercise& exercise : assignment_.exercises) {
      if (errors_.contains(exercise.file) || own_.contains(exercise.file)) continue;
      if (!files.contains(exercise.file)) {
        errors_[exercise.file] = exercise.file + " was not taken";
        continue;
      }
      const fs::path object = folder_ / fmt::format("{}.o", own_.size() + errors_.size());
      const std::string error = compiler_.compile(exercise.file, object);
      if (error.empty()) {
        own_[exercise.file] = object;
      } else {
        errors_[exercise.file] = error;
      }
    }
  }

  /// Links all objects. If that fails, starts with stubs and adds one file after another in the
  /// exercises' order, and leaves out each that breaks the link. Returns the linker's message if it
  /// fails even then.
  std::string link(const fs::path& program) {
    if (compiler_.link(with_stubs(own_), program).empty()) return "";
    const auto all = std::exchange(own_, {});
    for (const Exercise& exercise : assignment_.exercises) {
      const auto object = all.find(exercise.file);
      if (object == all.end() || !own_.insert(*object).second) continue;
      const std::string error = compiler_.link(with_stubs(own_), program);
      if (error.empty()) continue;
      errors_[exercise.file] = error;
      own_.erase(exercise.file);
    }
    return compiler_.link(with_stubs(own_), program);
  }

  /// Links the file of an exercise and those that it builds on, with stubs in place of all others.
  /// Returns whether that is a program: it is none if one of them calls a function of the others.
  bool link_alone(const Exercise& exercise, const fs::path& program) const {
    std::map<std::string, fs::path> needed;
    for (const std::string& file : files_behind(assignment_, exercise)) {
      const auto object = own_.find(file);
      needed[file] = object == own_.end() ? compiler_.toolkit().stub_of(file) : object->second;
    }
    return compiler_.are_complete(readable(needed)) &&
           compiler_.link(with_stubs(needed), program).empty();
  }

  /// The messages, by exercise.
  std::map<std::string, std::string> errors() const {
    std::map<std::string, std::string> errors;
    for (const Exercise& exercise : assignment_.exercises) {
      const auto error = errors_.find(exercise.file);
      if (error != errors_.end()) errors[exercise.id] = error->second;
    }
    return errors;
  }

 private:
  std::vector<Readable> with_stubs(const std::map<std::string, fs::path>& own) const {
    std::map<std::string, fs::path> objects = own;
    for (const Exercise& exercise : assignment_.exercises) {
      objects.emplace(exercise.file, compiler_.toolkit().stub_of(exercise.file));
    }
    return readable(objects);
  }

  static std::vector<Readable> readable(const std::map<std::string, fs::path>& objects) {
    std::vector<Readable> readable;
    for (const auto& [file, object] : objects) {
      readable.push_back({object, "/objects/" + fs::path(file).filename().string() + ".o"});
    }
    return readable;
  }

  const Assignment& assignment_;
  const Compiler& compiler_;
  fs::path folder_;
  std::map<std::string, fs::path> own_;
  std::map<std::string, std::string> errors_;  ///< by file
};

}  // namespace

void make_executable(const fs::path& program) {
  using fs::perms;
  fs::permissions(program, perms::owner_all | perms::group_read | perms::group_exec |
                               perms::others_read | perms::others_exec);
}

Built build(const Assignment& assignment, const fs::path& toolkit, const Files& files,
            const fs::path& scratch, Isolation isolation, const std::optional<OtherMain>& other) {
  const fs::path folder = fs::absolute(scratch);
  fs::create_directories(folder);
  Compiler compiler(assignment, toolkit, folder, isolation);
  compiler.write_project(assignment, files);
  if (other) compiler.use(*other);
  Objects objects(assignment, compiler, folder / "objects");
  objects.compile(files);

  Built built;
  built.program = folder / "program";
  built.link_error = objects.link(built.program);
  built.compile_errors = objects.errors();
  built.seconds = compiler.seconds();
  if (!built.link_error.empty()) return built;
  make_executable(built.program);
  if (other) return built;
  for (const Exercise& exercise : assignment.exercises) {
    const fs::path program = folder / ("program of " + exercise.id);
    if (!objects.link_alone(exercise, program)) continue;
    make_executable(program);
    built.alone[exercise.id] = program;
  }
  built.seconds = compiler.seconds();
  return built;
}

}  // namespace course

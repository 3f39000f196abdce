// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

#include "command_line/exit_codes.hpp"
#include "command_line/stage.hpp"
#include "literate/excerpts/excerpt.hpp"
#include "literate/main/stage_record.hpp"
#include "literate/main/stages.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/staging.hpp"

namespace literate {
namespace fs = std::filesystem;
using command_line::ExitCode;
namespace {

// Tests before the computation whether document.write() will be able to write, and leaves no trace.
void require_writable(const fs::path& output) {
  std::error_code ignored;
  std::vector<fs::path> missing;
  fs::path folder = fs::absolute(output / "").lexically_normal().parent_path();
  for (; !fs::exists(folder, ignored) && folder.has_relative_path(); folder = folder.parent_path())
    missing.push_back(folder);
  { const sys::Staging trial(output); }
  for (const fs::path& made : missing) fs::remove(made, ignored);
}

// What a file was when it was read: its bytes, and what changes with each writing to it and with
// each other file that takes its place.
struct FileAsRead {
  explicit FileAsRead(const fs::path& file) : digest(sys::sha256_of_file(file)) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return;
    change = {status.st_dev, status.st_ino, status.st_ctim.tv_sec, status.st_ctim.tv_nsec};
  }
  bool operator==(const FileAsRead&) const = default;

  std::string digest;
  std::tuple<dev_t, ino_t, time_t, long> change;
};

// The computation reads its case more than once, so it is repeated if the case was saved meanwhile.
Document computed(const Inputs& inputs, const Compute& compute) {
  constexpr int most_runs = 5;
  for (int n_runs = 0; n_runs < most_runs; ++n_runs) {
    const FileAsRead before(inputs.case_file);
    Document document;
    compute_guarded(document, inputs, compute);
    if (FileAsRead(inputs.case_file) == before) {
      document.computed_from(inputs.case_file.filename().string(), before.digest);
      return document;
    }
    command_line::complain(
        fmt::format("warning: '{}' was saved while it was computed from; it is computed again",
                    inputs.case_file.string()),
        ExitCode::success);
  }
  throw sys::InputError(fmt::format("'{}' was saved {} times while it was computed from",
                                    inputs.case_file.string(), most_runs));
}

// All that a later look holds the results against. Data from outside the checkout are known by
// their names alone and left to the time stamps.
FileDigests files_read(const Settings& settings, const Document& document) {
  FileDigests files = this_program();
  files[fs::absolute(settings.case_file).string()] = document.registered().case_sha256;
  const fs::path root = fs::weakly_canonical(settings.root);
  for (const auto& [name, digest] : document.attachments().digests()) {
    if (fs::is_regular_file(root / name)) files[(root / name).string()] = digest;
  }
  const fs::path severity = settings.severity_record();
  if (fs::exists(severity)) files[severity.string()] = sys::sha256_of_file(severity);
  return files;
}

// A case that cannot be read is told before all else. One from a pipe, which can be read only once,
// is kept beside the output.
fs::path case_to_read(const Settings& settings) {
  const std::string text = sys::read_file(settings.case_file);
  if (fs::is_regular_file(settings.case_file)) return settings.case_file;
  const fs::path kept = settings.output / "generated.case.toml";
  sys::write_if_changed(kept, text);
  return kept;
}

ExitCode run(Settings settings, const Paper& paper, const Compute& compute) {
  const command_line::Stage computing("compute");
  settings.case_file = case_to_read(settings);
  const Inputs inputs{.case_file = settings.case_file,
                      .source = settings.root,
                      .excerpts = find_excerpts(settings.root, paper.source_folders),
                      .paper = settings.name};
  require_compiled(inputs.excerpts, paper.excerpts);
  require_writable(settings.generated());
  StageRecord record(settings.record("compute"));
  Document document = computed(inputs, compute);
  document.severity(read_severity(settings.severity_record(), settings.root, settings.case_file));
  document.write(settings.generated(), inputs.excerpts);
  record.done(files_read(settings, document));
  const auto counted = [](std::size_t n, const char* name) {
    return fmt::format("{} {}{}", n, name, n == 1 ? "" : "s");
  };
  computing.done(fmt::format(
      "{}, {}, {}, {}, {}", counted(document.values().size(), "value"),
      counted(document.tables().size(), "table"), counted(document.figures().size(), "figure"),
      counted(document.checks().size(), "check"), counted(document.claims().size(), "claim")));
  // The document is written with its faults, which stamp every page; `typeset` and `check` tell
  // them.
  return ExitCode::success;
}

}  // namespace

void add_compute_stage(CLI::App& program, ExitCode& exit_code, const Paper& paper,
                       const Compute& compute) {
  add_stage(program, exit_code, "compute",
            "Compute values and tables and what the figures show, and write them",
            [&](const Settings& settings) { return run(settings, paper, compute); });
}

}  // namespace literate

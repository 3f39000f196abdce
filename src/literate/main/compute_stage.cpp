// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "command_line/options.hpp"
#include "command_line/stage.hpp"
#include "literate/excerpts/find_excerpts.hpp"
#include "literate/main/stages.hpp"
#include "system/files.hpp"
#include "system/staging.hpp"

namespace literate {
namespace fs = std::filesystem;
using command_line::ExitCode;
namespace {

struct ComputeOptions {
  std::string case_file;
  std::string output;
  std::string source = ".";
  bool defers_verdict = false;
};

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

ExitCode run(const ComputeOptions& options, const Paper& paper, const Compute& compute) {
  const command_line::Stage computing("compute");
  sys::read_file(options.case_file);  // one that cannot be read is told before all else
  const Inputs inputs{.case_file = options.case_file,
                      .source = options.source,
                      .excerpts = find_excerpts(options.source, paper.source_folders)};
  require_compiled(inputs.excerpts, paper.excerpts);
  require_writable(options.output);
  Document document;
  compute(document, inputs);
  document.write(options.output, inputs.excerpts);
  computing.done(fmt::format("{} values, {} tables, {} figures, {} checks, {} claims",
                             document.values().size(), document.tables().size(),
                             document.figures().size(), document.checks().size(),
                             document.claims().size()));
  // The document is written with its faults, which stamp every page; `typeset` prints them when the
  // PDF exists.
  return options.defers_verdict ? ExitCode::success
                                : command_line::answer_faults(document.faults());
}

}  // namespace

void add_compute_stage(CLI::App& program, ExitCode& exit_code, const Paper& paper,
                       const Compute& compute) {
  using namespace command_line;
  add_command(
      program, "compute", "Compute values and tables and what the figures show, and write them",
      exit_code, [&paper, &compute](CLI::App& command) {
        auto options = std::make_shared<ComputeOptions>();
        add_required_text(command, "--case", options->case_file, "FILE", "Case file");
        add_required_text(command, "--output", options->output, "DIR", "Folder to write to");
        add_text(command, "--source", options->source, "DIR",
                 "The checkout, for the excerpts of its sources");
        add_switch(command, "--defer-verdict", options->defers_verdict,
                   "Leave it to `typeset` to tell what does not hold, and to exit 1");
        return [options, &paper, &compute] { return run(*options, paper, compute); };
      });
}

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "app/commands.hpp"
#include "app/compiled_excerpts.hpp"
#include "app/options.hpp"
#include "app/stage.hpp"
#include "literate/document/document.hpp"
#include "literate/excerpts/excerpt.hpp"
#include "paper/paper.hpp"
#include "parameters/case.hpp"
#include "system/staging.hpp"

namespace app {
namespace fs = std::filesystem;
namespace {

struct ReportOptions {
  std::string case_file;
  std::string output;
  std::string source = ".";
  bool defers_verdict = false;
};

// Tries out what document.write() will do, before the computation, and leaves no trace.
void require_writable(const fs::path& output) {
  std::error_code ignored;
  std::vector<fs::path> missing;
  fs::path folder = fs::absolute(output / "").lexically_normal().parent_path();
  for (; !fs::exists(folder, ignored) && folder.has_relative_path(); folder = folder.parent_path())
    missing.push_back(folder);
  { const sys::Staging trial(output); }
  for (const fs::path& made : missing) fs::remove(made, ignored);
}

ExitCode run(const ReportOptions& options) {
  const Stage computing("compute");
  const parameters::Case from_file = parameters::read_case(options.case_file);
  const auto excerpts = literate::find_excerpts(options.source, {"src"});
  literate::require_compiled(excerpts, compiled_excerpts);
  require_writable(options.output);
  literate::Document document;
  paper::compute(document, from_file, paper::Listings{options.source, excerpts});
  computing.done(fmt::format("{} values, {} tables, {} checks, {} claims", document.values().size(),
                             document.tables().size(), document.checks().size(),
                             document.claims().size()));

  const Stage drawing("draw");
  document.write(options.output, excerpts);
  drawing.done(fmt::format("{} figures", document.figures().size()));
  // Written with its faults, which stamp every page; `typeset` tells them when the PDF is there.
  return options.defers_verdict ? ExitCode::success : answer_faults(document.faults());
}

}  // namespace

void add_report_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "report",
              "Compute all values, tables and figures of the report and write them for LaTeX",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<ReportOptions>();
                add_required_text(command, "--case", options->case_file, "FILE", "Case file");
                add_required_text(command, "--output", options->output, "DIR",
                                  "Folder to write to");
                add_text(command, "--source", options->source, "DIR",
                         "The checkout, for the excerpts of its sources");
                add_switch(command, "--defer-verdict", options->defers_verdict,
                           "Leave it to `typeset` to tell what does not hold, and to exit 1");
                return [options] { return run(*options); };
              });
}

}  // namespace app

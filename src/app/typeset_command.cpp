// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/stage.hpp"
#include "literate/names.hpp"
#include "literate/references.hpp"
#include "literate/typeset.hpp"

namespace app {
namespace {

struct Options {
  std::string document, main_file = "report.tex", generated, build, output;
};

ExitCode run(const Options& options) {
  const Stage typesetting("typeset");
  const literate::Names names =
      literate::read_names(std::filesystem::path(options.generated) / "names.json");
  const literate::ReferenceReport references = literate::check_references(options.document, names);
  for (const std::string& error : references.errors) fmt::print(stderr, "halfspace: {}\n", error);
  if (!references.errors.empty()) return ExitCode::bad_input;

  literate::typeset({.source_dir = options.document,
                     .main_file = options.main_file,
                     .generated_dir = options.generated,
                     .build_dir = options.build,
                     .output_pdf = options.output});
  typesetting.done(std::filesystem::path(options.output).filename().string());
  return answer_faults(names.faults);
}

}  // namespace

void add_typeset_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "typeset", "Typeset the report with LaTeX from what `report` wrote",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<Options>();
                add_required_text(command, "--document", options->document, "DIR",
                                  "Folder of the LaTeX document");
                add_text(command, "--main", options->main_file, "FILE", "Its main file");
                add_required_text(command, "--generated", options->generated, "DIR",
                                  "Folder that `report` wrote");
                add_required_text(command, "--build", options->build, "DIR",
                                  "Folder for LaTeX's own files");
                add_required_text(command, "--output", options->output, "FILE", "The PDF");
                return [options] { return run(*options); };
              });
}

}  // namespace app

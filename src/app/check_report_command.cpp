// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "command_line/options.hpp"
#include "literate/document/names.hpp"
#include "literate/prose/prose_lint.hpp"
#include "literate/prose/references.hpp"

namespace app {
namespace {

struct CheckReportCommandOptions {
  std::string document, generated;
};

void print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print(stderr, "halfspace: {}\n", line);
}

ExitCode run(const CheckReportCommandOptions& options) {
  const literate::Names names =
      literate::read_names(std::filesystem::path(options.generated) / "names.json");
  const literate::ReferenceReport references = literate::check_references(options.document, names);
  const std::vector<std::string> typed = literate::typed_numbers_below(options.document);
  print(references.errors);
  for (const std::string& name : references.unused) {
    fmt::print(stderr, "halfspace: {} is registered and not used\n", name);
  }
  print(typed);
  const ExitCode of_faults = answer_faults(names.faults);
  if (!references.errors.empty()) return ExitCode::bad_input;
  if (!references.unused.empty() || !typed.empty()) return ExitCode::failed;
  return of_faults;
}

}  // namespace

void add_check_report_command(CLI::App& program, ExitCode& exit_code) {
  add_command(program, "check-report",
              "Check the prose of the report against what `report` wrote: unknown names, unused "
              "ones, typed numbers, what does not hold",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<CheckReportCommandOptions>();
                add_required_text(command, "--document", options->document, "DIR",
                                  "Folder of the LaTeX document");
                add_required_text(command, "--generated", options->generated, "DIR",
                                  "Folder that `report` wrote");
                return [options] { return run(*options); };
              });
}

}  // namespace app

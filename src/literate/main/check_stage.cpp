// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "literate/document/names.hpp"
#include "literate/main/stages.hpp"
#include "literate/prose/figure_widths.hpp"
#include "literate/prose/images.hpp"
#include "literate/prose/prose_lint.hpp"
#include "literate/prose/references.hpp"
#include "literate/prose/restyle.hpp"

namespace literate {
namespace {

using command_line::complain;
using command_line::ExitCode;

struct CheckOptions {
  std::string document, generated;
};

void print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) complain(line, ExitCode::failed);
}

ExitCode run(const CheckOptions& options) {
  const Names names = read_names(std::filesystem::path(options.generated) / "names.json");
  ReferenceReport references = check_references(options.document, names);
  std::ranges::move(images_of(options.document).errors, std::back_inserter(references.errors));
  std::ranges::move(figure_width_errors(options.document), std::back_inserter(references.errors));
  const std::vector<std::string> typed = typed_numbers_below(options.document);
  const Restyled restyled = restyled_values(options.document, names);
  print(references.errors);
  print(restyled.errors);
  for (const std::string& name : references.unused) {
    complain(name + " is registered and not used", ExitCode::failed);
  }
  print(typed);
  const ExitCode of_faults = command_line::answer_faults(names.faults);
  if (!references.errors.empty() || !restyled.errors.empty()) return ExitCode::bad_input;
  if (!references.unused.empty() || !typed.empty()) return ExitCode::failed;
  return of_faults;
}

}  // namespace

void add_check_stage(CLI::App& program, ExitCode& exit_code) {
  using namespace command_line;
  add_command(program, "check",
              "Check the prose of the document against what `compute` wrote: unknown names, unused "
              "ones, typed numbers, what does not hold",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<CheckOptions>();
                add_required_text(command, "--document", options->document, "DIR",
                                  "Folder of the LaTeX document");
                add_required_text(command, "--generated", options->generated, "DIR",
                                  "Folder that `compute` wrote");
                return [options] { return run(*options); };
              });
}

}  // namespace literate

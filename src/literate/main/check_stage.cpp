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
#include "literate/prose/quotations.hpp"
#include "literate/prose/references.hpp"
#include "literate/prose/restyle.hpp"
#include "literate/prose/statements.hpp"

namespace literate {
namespace {

using command_line::complain;
using command_line::ExitCode;

struct CheckOptions {
  std::string document, generated, quoted_text;
};

void print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) complain(line, ExitCode::failed);
}

ExitCode run(const CheckOptions& options) {
  const Names names = read_names(std::filesystem::path(options.generated) / "names.json");
  ReferenceReport references = check_references(options.document, names);
  std::ranges::move(images_of(options.document).errors, std::back_inserter(references.errors));
  std::ranges::move(figure_width_errors(options.document), std::back_inserter(references.errors));
  std::vector<std::string> findings = typed_numbers_below(options.document);
  const auto add = [&](std::vector<std::string> more) {
    std::ranges::move(more, std::back_inserter(findings));
  };
  add(typed_numbers_in(names.texts));
  add(unquoted_statements(statements_below(options.document)));
  if (!options.quoted_text.empty()) {
    add(quotation_errors(read_quotations(options.document), options.quoted_text));
  }
  const Restyled restyled = restyled_values(options.document, names);
  print(references.errors);
  print(restyled.errors);
  for (const std::string& name : references.unused) {
    complain(name + " is registered and not used", ExitCode::failed);
  }
  print(findings);
  const ExitCode of_faults = command_line::answer_faults(names.faults);
  if (!references.errors.empty() || !restyled.errors.empty()) return ExitCode::bad_input;
  if (!references.unused.empty() || !findings.empty()) return ExitCode::failed;
  return of_faults;
}

}  // namespace

void add_check_stage(CLI::App& program, ExitCode& exit_code) {
  using namespace command_line;
  add_command(program, "check",
              "Check the prose of the document against what `compute` wrote: unknown names, unused "
              "ones, typed numbers, quotations, what does not hold",
              exit_code, [](CLI::App& command) {
                auto options = std::make_shared<CheckOptions>();
                add_required_text(command, "--document", options->document, "DIR",
                                  "Folder of the LaTeX document");
                add_required_text(command, "--generated", options->generated, "DIR",
                                  "Folder that `compute` wrote");
                add_text(command, "--quoted-text", options->quoted_text, "FILE",
                         "The text that is quoted: hold every quotation against it");
                return [options] { return run(*options); };
              });
}

}  // namespace literate

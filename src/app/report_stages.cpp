// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of the report, which are the engine's, with what this report computes.
#include "app/commands.hpp"
#include "literate/main/stages.hpp"
#include "paper/paper.hpp"
#include "parameters/case.hpp"
#include "toolchain/libraries.hpp"

namespace app {
namespace {

literate::Paper described_paper() {
  literate::Paper paper = literate::this_paper();
  paper.libraries = toolchain::libraries();
  return paper;
}

void compute(literate::Document& document, const literate::Inputs& inputs) {
  paper::compute(document, parameters::read_case(inputs.case_file),
                 paper::Listings{inputs.source, inputs.excerpts}, literate::this_paper());
}

}  // namespace

void add_report_stages(CLI::App& program, ExitCode& exit_code) {
  static const literate::Paper paper = described_paper();
  static const literate::Compute computation = compute;
  literate::add_stages(program, exit_code, paper, computation);
}

}  // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
// The program that makes the report: the engine's stages, with what this report computes.
#include "literate/main/main.hpp"

#include <iostream>

#include "paper/paper.hpp"
#include "parameters/case.hpp"
#include "toolchain/libraries.hpp"

int main(int argc, char** argv) {
  literate::Paper paper = literate::this_paper();
  paper.libraries = toolchain::libraries();
  return literate::main(
      argc, argv, paper, [](literate::Document& document, const literate::Inputs& inputs) {
        const std::string log = paper::compute(document, parameters::read_case(inputs.case_file));
        if (!log.empty()) std::cerr << "halfspace: " << log << '\n';
      });
}

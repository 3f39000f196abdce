// SPDX-License-Identifier: GPL-3.0-or-later
// The program that makes the report: the engine's main() with this report's computations.
#include "literate/main/main.hpp"

#include <iostream>

#include "paper/paper.hpp"
#include "parameters/case.hpp"

int main(int argc, char** argv) {
  return literate::main(
      argc, argv, [](literate::Document& document, const std::filesystem::path& case_file) {
        const std::string log = paper::compute(document, parameters::read_case(case_file));
        if (!log.empty()) std::cerr << log << '\n';
      });
}

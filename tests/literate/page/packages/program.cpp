// SPDX-License-Identifier: GPL-3.0-or-later
// The program of a paper that computes nothing.
#include "literate/main/main.hpp"

int main(int argc, char** argv) {
  return literate::main(argc, argv, {.project = "packages"},
                        [](literate::Document&, const literate::Inputs&) {});
}

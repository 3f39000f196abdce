// SPDX-License-Identifier: GPL-3.0-or-later
#include "registrations.hpp"

int main(int argc, char** argv) {
  return literate::main(argc, argv, literate::this_paper(),
                        [](literate::Document& document, const literate::Inputs& inputs) {
                          register_all(document, inputs, read_sample(inputs.case_file));
                        });
}

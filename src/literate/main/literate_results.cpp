// SPDX-License-Identifier: GPL-3.0-or-later
// Rounds the numbers that a script registered, decides its claims, and writes the paper's folder.
#include <filesystem>

#include "literate/document/read_document.hpp"
#include "literate/main/main.hpp"

int main(int argc, char** argv) {
  constexpr const char* usage =
      "usage: literate-results REGISTERED.json FOLDER [CASE]\n"
      "Rounds the numbers that a script registered, decides its claims, and writes FOLDER as the\n"
      "program of a paper does. CASE is the file that the script computed from.";
  return literate::run(argc, argv, argc == 3 || argc == 4, usage, [&] {
    const literate::Document document = literate::read_document(argv[1]);
    const std::filesystem::path case_file = argc == 4 ? argv[3] : argv[1];
    return literate::write_and_report(document, argv[2], case_file.filename().string());
  });
}

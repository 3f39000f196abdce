// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace literate {

/// What a page is made of.
struct PageSources {
  std::filesystem::path document;   ///< folder of the LaTeX document
  std::string main_file;            ///< in it
  std::filesystem::path generated;  ///< what `compute` and `draw` wrote
  std::filesystem::path aux;        ///< of the PDF, with all its numbers
  std::filesystem::path engine;     ///< folder with filter.lua
  std::filesystem::path build;      ///< folder for the files that pandoc reads
  std::string known = {};           ///< definitions for what LaTeX does and a page does not
  std::string repository = {};      ///< the state of the repository, \LiterateRepository
};

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "literate/document/document.hpp"

namespace literate {

/// A file of numbers and the script that wrote it.
struct NumbersAndScript {
  AttachedFile numbers;
  AttachedFile script;
};

/// Reads a file as text; throws ImportError naming it if it cannot be read.
std::string read_numbers(const std::filesystem::path& file);

/// Puts a file of numbers, whose text was read already, together with its script. Both are named
/// relative to `root`, or by their file name alone if they lie elsewhere.
///
/// Throws ImportError if the script cannot be read, or if either name holds characters other than
/// letters, digits and _ + . , = / -, which LaTeX and arXiv do not all take.
NumbersAndScript with_script(const std::filesystem::path& file, std::string text,
                             const std::filesystem::path& script,
                             const std::filesystem::path& root);

}  // namespace literate

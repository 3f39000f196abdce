// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "literate/document/document.hpp"

namespace literate {

/// values.tex: what `\val`, `\ifflag`, `\tab`, `\fig` and `\claim` look up, a command a line.
std::string values_tex(const Document& document, const std::string& case_name);

/// values.csv: every value as it is printed and unrounded, with its uncertainty, unit and place.
std::string values_csv(const Document& document);

/// tables.csv: every cell of every table.
std::string tables_csv(const Document& document);

}  // namespace literate

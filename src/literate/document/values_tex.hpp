// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "literate/document/document.hpp"

namespace literate {

/// Returns values.tex, in which `\val`, `\ifflag`, `\tab`, `\fig` and `\claim` look up names: one
/// command on each line.
std::string values_tex(const Document& document, const std::string& case_name);

/// Returns values.csv: every value, printed and unrounded, with its errors, unit and place.
std::string values_csv(const Document& document);

/// Returns tables.csv: every cell of every table.
std::string tables_csv(const Document& document);

}  // namespace literate

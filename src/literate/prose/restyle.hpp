// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "literate/document/names.hpp"
#include "literate/values/value.hpp"

namespace literate {

/// A stored value printed in another way: `\val[options]{key}`.
///
/// Options are separated by commas: `digits=3` and `decimals=2`, `format=` fixed, significant,
/// scientific, percent or uncertain, and `unit=mm`, into which the value is converted (a unit with
/// a comma stands in braces; `percent` and `1` are units of a ratio). What is not said stays:
/// notation, unit, per cent, rounding up of a bound. The number is rounded half to even from the
/// stored double; conversion of units rounds once before. Throws std::invalid_argument naming
/// option, value and what is allowed: for a text, an unknown option or one given twice, digits
/// beyond 17, digits that are not earned, and a unit into which the value does not convert by a
/// factor.
Value restyled(const StoredNumber& stored, std::string_view options);

/// The unrounded number in the unit of `\rawval[unit=mm]{key}`, which is the only option there.
double restyled_number(const StoredNumber& stored, std::string_view options);

/// What a document's uses of \val and \rawval with options need, and what is wrong with them.
struct Restyled {
  /// The definitions that literate.sty reads as restyled.tex, one line for each variant, sorted.
  std::string latex;
  /// «folder/file.tex:line:column: what is wrong», in the order of the text.
  std::vector<std::string> errors;
};

/// Reads the *.tex files below a folder. Uses of unknown keys are left to check_references. Throws
/// sys::OutputError if the folder or a file cannot be read.
Restyled restyled_values(const std::filesystem::path& source_dir, const Names& names);

}  // namespace literate

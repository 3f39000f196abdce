// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace literate {

/// What TeX takes an atom of a formula for, which decides the spaces around it.
enum class AtomClass : char {
  ordinary,
  function,
  large,
  binary,
  relation,
  open,
  close,
  punctuation,
  space
};

struct MathSymbol {
  std::string_view characters;
  AtomClass atom_class;
};

/// What \name prints in a formula; none for a command that is no symbol.
std::optional<MathSymbol> math_symbol(std::string_view name);

/// The name of a function such as \ln, and whether limits stand below it; none for other commands.
struct MathFunction {
  std::string_view name;
  bool takes_limits;
};
std::optional<MathFunction> math_function(std::string_view name);

/// The accent that \bar and its kin put on their argument; empty for other commands.
std::string_view math_accent(std::string_view name);

/// A letter or digit in an alphabet of Unicode: \mathbf, \mathcal, \mathbb, \mathfrak, \mathsf,
/// \mathtt or \boldsymbol; the character itself where the alphabet lacks it.
std::string math_letter(std::string_view alphabet, std::string_view character);

}  // namespace literate

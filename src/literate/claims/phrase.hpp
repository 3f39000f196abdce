// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>

#include "literate/values/value.hpp"

namespace literate {

/// A phrase as plain text, for messages, and as LaTeX.
struct Phrase {
  std::string plain;
  std::string latex;

  const std::string& printed() const { return plain; }
};

/// Puts values and phrases into words that are the same in LaTeX: phrase("{} of {}", part, whole).
template <typename... Parts>
Phrase phrase(std::string_view words, const Parts&... parts) {
  const auto latex_of = [](const auto& part) -> const std::string& {
    if constexpr (requires { part.latex(); }) {
      return part.latex();
    } else {
      return part.latex;
    }
  };
  return {fmt::format(fmt::runtime(words), parts.printed()...),
          fmt::format(fmt::runtime(words), latex_of(parts)...)};
}

}  // namespace literate

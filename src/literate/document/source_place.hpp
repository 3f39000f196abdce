// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <source_location>
#include <string>

namespace literate {

/// A line of code that registered something.
struct SourcePlace {
  std::string file;      ///< relative to the checkout
  std::string function;  ///< with its namespace, without its parameters
  unsigned line = 0;
  unsigned column = 0;  ///< 0 where it is not known
};

/// The place as the compiler knows it.
SourcePlace place_of(const std::source_location& location);

/// Writes a place as «file:line», for messages.
std::string text_of(const SourcePlace& place);

}  // namespace literate

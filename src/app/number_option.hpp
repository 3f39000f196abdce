// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "app/number_text.hpp"

namespace app {

/// A numeric flag that may be left out, such as --young 30e6.
class NumberOption {
 public:
  NumberOption(CLI::App& command, const std::string& flag, const std::string& help) : flag_(flag) {
    command.add_option(flag, text_, help)->type_name("NUMBER");
  }

  /// The number given, if any; throws InputError if it is none.
  std::optional<double> number() const {
    if (text_.empty()) return std::nullopt;
    return parse_number(flag_, text_);
  }

  /// The number given, or else the case's; throws InputError where there is neither.
  double number_or(std::optional<double> from_case) const {
    if (const auto given = number()) return *given;
    if (from_case) return *from_case;
    throw InputError(flag_ + " is missing: give it, or a --case that has it");
  }

  const std::string& text() const { return text_; }
  const std::string& flag() const { return flag_; }

 private:
  std::string flag_;
  std::string text_;
};

}  // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/loads.hpp"

#include <fmt/core.h>
#include <muParser.h>

#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "system/error.hpp"

namespace app {
namespace {

// muParser's reason alone: without the position, the formula and the full stop.
std::string reason_of(const mu::ParserError& error) {
  std::string reason = error.GetMsg();
  for (const char* ending : {" found at position", " at position", " at expression position"}) {
    const std::size_t at = reason.find(ending);
    if (at != std::string::npos) reason.erase(at);
  }
  while (!reason.empty() && reason.back() == '.') reason.pop_back();
  if (!reason.empty()) {
    reason[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(reason[0])));
  }
  return reason;
}

[[noreturn]] void refuse(const std::string& formula, const mu::ParserError& error) {
  // Where muParser does not know the place, something is missing at the end of the formula.
  const bool is_known = error.GetPos() >= 0 && error.GetPos() < static_cast<int>(formula.size());
  const std::size_t column = is_known ? static_cast<std::size_t>(error.GetPos()) : formula.size();
  throw sys::InputError(
      fmt::format("expression \"{}\", column {}: {}", formula, column + 1, reason_of(error)));
}

// The parser keeps the address of x, so both live together and stay where they are.
struct Formula {
  mu::Parser parser;
  double x = 0;
};

}  // namespace

std::function<double(double)> parse_expression(const std::string& formula,
                                               const std::map<std::string, double>& constants) {
  const auto parsed = std::make_shared<Formula>();
  try {
    parsed->parser.DefineVar("x", &parsed->x);
    parsed->parser.DefineConst("pi", std::numbers::pi);
    for (const auto& [name, value] : constants) parsed->parser.DefineConst(name, value);
    parsed->parser.SetExpr(formula);
    parsed->parser.Eval();  // compiles it
  } catch (const mu::ParserError& error) {
    refuse(formula, error);
  }
  if (parsed->parser.GetNumResults() != 1) {
    throw sys::InputError(fmt::format("expression \"{}\": {} formulas, but one is needed", formula,
                                      parsed->parser.GetNumResults()));
  }
  return [formula, parsed](double x) {
    double value = std::numeric_limits<double>::quiet_NaN();
    try {
      parsed->x = x;
      value = parsed->parser.Eval();
    } catch (const mu::ParserError& error) {
      refuse(formula, error);
    }
    if (std::isfinite(value)) return value;
    throw sys::InputError(
        fmt::format("expression \"{}\" has no finite value at x = {}", formula, x));
  };
}

}  // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/values_tex.hpp"

#include <fmt/core.h>

#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/csv.hpp"

namespace literate {
namespace {

std::string value_tex(const std::string& key, const Value& value) {
  const std::string raw = value.is_text() ? "" : plain(shortest(value.number()));
  const int n_earned = value.n_earned_digits();
  std::string text = fmt::format("\\LiterateValue{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n", key,
                                 value.latex(), latex_escaped(value.printed()), raw, n_earned);
  for (int n = 1; n <= n_earned; ++n) {
    const Value rounded = value.formatted(value.format().with_digits(n));
    text += fmt::format("\\LiterateRounded{{{}}}{{{}}}{{{}}}{{{}}}\n", key, n, rounded.latex(),
                        latex_escaped(rounded.printed()));
  }
  return text;
}

}  // namespace

std::string values_tex(const Document& document, const std::string& case_name) {
  std::string text = fmt::format("\\LiterateCase{{{}}}\n", latex_escaped(case_name));
  if (const std::size_t n_faults = document.faults().size(); n_faults > 0) {
    text += fmt::format("\\LiterateFailed{{{}}}\n", n_faults);
  }
  for (const auto& [key, value] : document.values()) text += value_tex(key, value);
  for (const auto& [key, is_set] : document.flags()) {
    text += fmt::format("\\LiterateFlag{{{}}}{{{}}}\n", key, is_set);
  }
  for (const auto& [name, table] : document.tables()) {
    text += fmt::format("\\LiterateTable{{{}}}\n", name);
  }
  for (const auto& [name, figure] : document.figures()) {
    text += fmt::format("\\LiterateFigure{{{}}}\n", name);
  }
  int number = 0;
  for (const auto& [id, claim] : document.claims()) {
    text += fmt::format("\\LiterateClaim{{{}}}{{{}}}{{{}}}{{{}}}\n", id, ++number,
                        name_of(claim.verdict()), name_of(claim.expected));
  }
  return text;
}

std::string values_csv(const Document& document) {
  std::string text = "key,printed,number,bound,standard,unit,place\n";
  for (const auto& [key, value] : document.values()) {
    const auto& known = value.known();
    text += sys::csv_line({key, value.printed(), value.is_text() ? "" : round_trip(value.number()),
                           known ? round_trip(known->bound) : "",
                           known && known->standard > 0 ? round_trip(known->standard) : "",
                           value.unit(), document.place_of("value", key)});
  }
  return text;
}

std::string tables_csv(const Document& document) {
  std::string text = "table,row,column,heading,unit,printed,number,bound,standard\n";
  for (const auto& [name, table] : document.tables()) {
    const auto printed = table.printed();
    for (std::size_t row = 0; row < printed.size(); ++row) {
      for (std::size_t i = 0; i < table.columns().size(); ++i) {
        const Cell& cell = table.rows()[row][i];
        const Column& column = table.columns()[i];
        const bool is_number = cell.number() != nullptr;
        const auto& known = cell.known();
        text += sys::csv_line(
            {name, std::to_string(row + 1), std::to_string(i + 1), column.heading(), column.unit(),
             is_number ? printed[row][i] : cell.given(),
             is_number ? round_trip(*cell.number()) : "", known ? round_trip(known->bound) : "",
             known && known->standard > 0 ? round_trip(known->standard) : ""});
      }
    }
  }
  return text;
}

}  // namespace literate

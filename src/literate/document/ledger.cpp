// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/ledger.hpp"

#include <fmt/core.h>

#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/csv.hpp"

namespace literate {

std::string ledger_tex(const Document& document) {
  std::string text;
  int number = 0;
  for (const auto& [id, claim] : document.claims()) {
    text += fmt::format("\\LiterateEntry{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}{{%\n", id, ++number,
                        name_of(claim.verdict()), name_of(claim.expected),
                        latex_escaped(document.place_of("claim", id)), claim.route);
    for (const Criterion& criterion : claim.criteria) {
      const Limit& limit = criterion.limit();
      text += fmt::format("\\LiterateCriterion{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}%\n",
                          criterion.name(), criterion.found().latex, criterion.limit_phrase().latex,
                          name_of(limit.kind()), author_latex(limit.reason()),
                          criterion.margin().text(), name_of(criterion.verdict()),
                          latex_escaped(criterion.missing()));
    }
    text += "}\n";
  }
  return text;
}

std::string claims_csv(const Document& document) {
  std::string text =
      "claim,verdict,expected,criterion,found,limit,kind,reason,outcome,margin_errors,"
      "margin_factor,place\n";
  const auto number = [](const std::optional<double>& known) {
    return known ? round_trip(*known) : std::string();
  };
  for (const auto& [id, claim] : document.claims()) {
    for (const Criterion& c : claim.criteria) {
      text += sys::csv_line({id, std::string(name_of(claim.verdict())),
                             std::string(name_of(claim.expected)), c.name(), c.found().plain,
                             c.limit_phrase().plain, std::string(name_of(c.limit().kind())),
                             c.limit().reason(), std::string(name_of(c.verdict())),
                             number(c.margin().errors), number(c.margin().factor),
                             document.place_of("claim", id)});
    }
  }
  return text;
}

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "literate/document/results_json.hpp"
#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/files.hpp"
#include "system/text.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

constexpr const char* results_name = "results.json";

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

/// values.tex, in which `\val`, `\ifflag`, `\tab`, `\fig` and `\claim` look up names: one command
/// on each line.
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

/// values.csv: every value, printed and unrounded, with its errors, unit and place.
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

/// tables.csv: every cell of every table.
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

/// ledger.tex: each claim with its criteria, which `\claimledger` prints.
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

/// claims.csv: one row for each criterion of each claim.
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

/// The files that an earlier run wrote; none if its list cannot be read.
std::vector<std::string> earlier_files(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / results_name, error)) return {};
  std::vector<std::string> files;
  try {
    files = nlohmann::json::parse(sys::read_file(folder / results_name)).at("files");
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  // An edited list must not reach other folders.
  std::erase_if(files, [](const fs::path& name) {
    return name.empty() || name.is_absolute() || std::ranges::find(name, "..") != name.end();
  });
  return files;
}

std::map<std::string, std::string> files_of(const Document& document,
                                            const std::string& case_name) {
  std::map<std::string, std::string> files{{"values.tex", values_tex(document, case_name)},
                                           {"ledger.tex", ledger_tex(document)},
                                           {"values.csv", values_csv(document)},
                                           {"claims.csv", claims_csv(document)},
                                           {"tables.csv", tables_csv(document)}};
  for (const auto& [name, table] : document.tables()) {
    files["tables/" + name + ".tex"] = table.latex();
    files["tables/" + name + ".csv"] = table.csv();
  }
  for (const auto& [name, figure] : document.figures()) {
    const std::string folder = "figures/" + name + "/";
    files[folder + "data.gp"] = figure_prelude(name, figure);
    for (const auto& [block, data] : figure.data) files[folder + block + ".csv"] = figure_csv(data);
  }
  return files;
}

}  // namespace

void write_folder(const Document& document, const fs::path& folder, const std::string& case_name) {
  const std::map<std::string, std::string> files = files_of(document, case_name);
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const auto& [name, text] : files) names.push_back(name);
  const std::string results = results_json(document, case_name, names);

  const std::vector<std::string> earlier = earlier_files(folder);
  for (const auto& [name, text] : files) sys::write_if_changed(folder / name, text);
  for (const std::string& name : earlier) {
    if (!files.contains(name) && name != results_name) sys::remove_file(folder / name);
  }
  sys::write_if_changed(folder / results_name, results);
}

}  // namespace literate

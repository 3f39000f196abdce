// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/document_tex.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/csv.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;

std::string values_tex(const Registered& registered) {
  std::string text;
  if (!registered.case_name.empty()) {
    text += fmt::format("\\renewcommand*\\papercase{{{}}}\n", escape_latex(registered.case_name));
  }
  for (const auto& [key, value] : registered.values) {
    text += fmt::format("\\LiterateValue{{{}}}{{{}}}{{{}}}\n", key, value.latex(),
                        escape_bookmark(value.printed()));
    if (value.number()) {
      text += fmt::format("\\LiterateRaw{{{}}}{{{}}}\n", key, bare_digits(*value.number()));
    }
  }
  for (const auto& [key, is_set] : registered.flags) {
    text += fmt::format("\\LiterateFlag{{{}}}{{{}}}\n", key, is_set ? "true" : "false");
  }
  for (const auto& [id, claim] : registered.claims) {
    text += fmt::format("\\LiterateClaim{{{}}}{{{}}}\n", id, name_of(claim.found()));
  }
  const std::size_t n_faults = faults(registered).size();
  if (n_faults > 0) {
    text +=
        fmt::format("\\LiterateStamp{{Not to be trusted: {} not as expected}}\n",
                    n_faults == 1 ? "a statement is" : fmt::format("{} statements are", n_faults));
  }
  return text;
}

namespace {

/// Lets LaTeX break a name after a dot, a hyphen, an underscore or a colon.
std::string breakable(const std::string& name) {
  std::string text;
  for (const char c : name) {
    text += escape_latex(std::string(1, c));
    if (c == '.' || c == '-' || c == ':' || c == '_') text += "\\allowbreak{}";
  }
  return text;
}

/// A word that is too long for the columns of the index, such as a digest, with breaks allowed
/// anywhere; empty for other texts.
std::string breakable_word(const std::string& printed) {
  constexpr std::size_t longest = 30;
  const bool is_word = std::ranges::all_of(printed, [](char c) { return c > ' ' && c < 0x7f; });
  if (printed.size() <= longest || !is_word) return {};
  std::string text;
  for (const char c : printed) text += escape_latex(std::string(1, c)) + "\\allowbreak{}";
  return text;
}

/// A number in the unit in which a value is printed.
std::string like(const Value& value, double number, const Format& format) {
  return value.is_percentage() ? Value(number, format.in_percent()).latex()
                               : Value(number, format, value.unit()).latex();
}

std::string standard_tex(const Value& value, const Uncertainty& uncertainty) {
  constexpr int n_digits = 2;
  constexpr double least_told = 0.05;
  const auto print = [&](double u) { return like(value, u, significant(n_digits)); };
  std::string text = "standard uncertainty " + print(uncertainty.standard);
  if (uncertainty.kinds.size() > 1) {
    std::vector<std::string> kinds;
    for (const auto& [kind, u] : uncertainty.kinds) {
      kinds.push_back(fmt::format("{} {}", escape_latex(kind), print(u)));
    }
    text += fmt::format(" ({})", fmt::join(kinds, ", "));
  }
  if (uncertainty.neglected > least_told * uncertainty.standard) {
    text += "; the second order, which is left out, is at most " +
            like(value, uncertainty.neglected, significant(n_digits).rounded_up());
  }
  return text;
}

}  // namespace

std::string error_tex(const Value& value) {
  if (value.is_as_is()) return "no error bound";
  if (!value.uncertainty()) return {};
  const Uncertainty& uncertainty = *value.uncertainty();
  if (uncertainty.error() == 0) return "exact";
  std::string text;
  if (uncertainty.standard > 0 || uncertainty.is_nonlinear())
    text = standard_tex(value, uncertainty);
  if (uncertainty.bound == 0) return text;
  const Format two_digits = scientific(2).rounded_up();
  if (uncertainty.sides) {
    return fmt::format("error $\\le$ {} below, {} above",
                       like(value, uncertainty.sides->first, two_digits),
                       like(value, uncertainty.sides->second, two_digits));
  }
  const std::string bound = like(value, uncertainty.bound, two_digits);
  return text + (text.empty() ? "" : ", ") + "error $\\le$ " + bound;
}

std::string index_tex(const Registered& registered) {
  std::string text;
  for (const auto& [key, value] : registered.values) {
    const std::string error = error_tex(value);
    text += fmt::format("\\LiterateIndexEntry{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n", key,
                        escape_latex_path(key), error,
                        escape_latex_path(text_of(registered.places.at({"value", key}))),
                        value.number() ? std::string() : breakable_word(value.printed()));
  }
  return text;
}

std::string values_csv(const Registered& registered) {
  std::string text = "key,printed,number,abs_error,below,above,standard,unit,place\n";
  const auto number = [](double x) { return fmt::format("{}", x); };
  for (const auto& [key, value] : registered.values) {
    const auto& uncertainty = value.uncertainty();
    const auto sides = uncertainty ? uncertainty->sides : std::nullopt;
    text += sys::csv_line(
        {key, value.printed(), value.number() ? number(*value.number()) : "",
         uncertainty ? number(uncertainty->told_bound()) : "", sides ? number(sides->first) : "",
         sides ? number(sides->second) : "",
         uncertainty && uncertainty->standard > 0 ? number(uncertainty->standard) : "",
         value.unit(), text_of(registered.places.at({"value", key}))});
  }
  return text;
}

std::string sources_csv(const Registered& registered) {
  std::string text = "kind,name,place,function\n";
  const auto add = [&](const std::string& kind, const std::string& name) {
    const SourcePlace& place = registered.places.at({kind, name});
    text += sys::csv_line({kind, name, text_of(place), place.function});
  };
  for (const auto& [name, figure] : registered.figures) add("figure", name);
  for (const auto& [name, table] : registered.tables) add("table", name);
  for (const auto& [id, claim] : registered.claims) add("claim", id);
  return text;
}

namespace {

std::string entry(const Registered& registered, const char* kind, const std::string& name,
                  const std::string& files) {
  const SourcePlace& place = registered.places.at({kind, name});
  return fmt::format("\\LiterateProvenance{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}{{%\n  {}}}\n", kind, name,
                     escape_latex(name), escape_latex_path(text_of(place)),
                     breakable(place.function), files);
}

}  // namespace

std::string provenance_tex(const Registered& registered, const fs::path& folder) {
  std::string text;
  for (const auto& [name, figure] : registered.figures) {
    // Its script may change after the computation, so the drawing says what it was made from.
    text += entry(registered, "figure", name,
                  fmt::format("\\LiterateFiles{{figures/{}/files.tex}}", name));
  }
  for (const auto& [name, table] : registered.tables) {
    const std::string file = fmt::format("tables/{}.csv", name);
    text +=
        entry(registered, "table", name,
              fmt::format("\\LiterateFile{{{}}}{{{}}}", file, sys::sha256_of_file(folder / file)));
  }
  return text + registered.attachments.latex("imports");
}

}  // namespace literate

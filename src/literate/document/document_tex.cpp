// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/document_tex.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;

std::string values_tex(const Document& document) {
  std::string text;
  for (const auto& [key, value] : document.values()) {
    text += fmt::format("\\LiterateValue{{{}}}{{{}}}{{{}}}\n", key, value.latex(),
                        escape_bookmark(value.printed()));
  }
  for (const auto& [key, is_set] : document.flags()) {
    text += fmt::format("\\LiterateFlag{{{}}}{{{}}}\n", key, is_set ? "true" : "false");
  }
  int number = 0;
  for (const auto& [id, claim] : document.claims()) {
    text += fmt::format("\\LiterateClaim{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n", id, ++number,
                        name_of(claim.found), claim.stated.latex(), claim.computed.latex());
  }
  const std::size_t n_faults = document.faults().size();
  if (n_faults > 0) {
    text +=
        fmt::format("\\LiterateStamp{{Not to be trusted: {} not as expected}}\n",
                    n_faults == 1 ? "a statement is" : fmt::format("{} statements are", n_faults));
  }
  return text;
}

namespace {

// «\LiterateLedgerSummary{all}{confirmed}{partly}{refuted}{not as expected}».
std::string ledger_summary(const Document& document) {
  const auto count = [&](auto&& is_meant) {
    return std::ranges::count_if(document.claims(),
                                 [&](const auto& entry) { return is_meant(entry.second); });
  };
  const auto count_of = [&](Verdict verdict) {
    return count([verdict](const Claim& claim) { return claim.found == verdict; });
  };
  return fmt::format("\\LiterateLedgerSummary{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n",
                     document.claims().size(), count_of(Verdict::confirmed),
                     count_of(Verdict::partly), count_of(Verdict::refuted),
                     count([](const Claim& claim) { return claim.found != claim.expected; }));
}

}  // namespace

std::string claims_tex(const Document& document) {
  std::string text = ledger_summary(document);
  for (const auto& [id, claim] : document.claims()) {
    text += fmt::format(
        "\\LiterateLedgerEntry{{{}}}\n  {{{}}}\n  {{{}}}\n  {{{}}}\n  {{{}}}\n  "
        "{{{}}}{{{}}}{{{}}}\n",
        id, escape_latex(claim.sentence), escape_latex(claim.place), escape_latex(claim.route),
        escape_latex(claim.tolerance), name_of(claim.expected), name_of(claim.found),
        escape_latex_path(text_of(document.place("claim", id))));
  }
  return text;
}

namespace {

// LaTeX may break a name after a dot, a hyphen or a colon.
std::string breakable(const std::string& name) {
  std::string text;
  for (const char c : name) {
    text += escape_latex(std::string(1, c));
    if (c == '.' || c == '-' || c == ':' || c == '_') text += "\\allowbreak{}";
  }
  return text;
}

}  // namespace

namespace {

// Text as the index prints it: words too long for its columns, such as digests, may break anywhere.
std::string index_text(const std::string& printed) {
  constexpr std::size_t longest = 30;
  const bool is_word = std::ranges::all_of(printed, [](char c) { return c > ' ' && c < 0x7f; });
  if (printed.size() <= longest || !is_word) return {};
  std::string text;
  for (const char c : printed) text += escape_latex(std::string(1, c)) + "\\allowbreak{}";
  return text;
}

}  // namespace

std::string index_tex(const Document& document) {
  std::string text;
  for (const auto& [key, value] : document.values()) {
    const std::string error =
        value.abs_error() ? scientific(rounded_up_to_digits(*value.abs_error(), 2)) : "";
    text += fmt::format("\\LiterateIndexEntry{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n", key,
                        escape_latex_path(key), error,
                        escape_latex_path(text_of(document.place("value", key))),
                        value.number() ? std::string() : index_text(value.printed()));
  }
  return text;
}

namespace {

// The files that one figure or table was made from and into, without what LaTeX reads.
std::vector<std::string> data_files(const fs::path& folder, const std::string& name) {
  std::vector<std::string> files;
  for (const std::string& file : sys::files_below(folder)) {
    const bool is_own = file.starts_with(name + ".");
    const bool is_data = file.ends_with(".dat") || file.ends_with(".gp") || file.ends_with(".csv");
    if (is_own && is_data) files.push_back(file);
  }
  return files;
}

std::string entry(const Document& document, const fs::path& folder, const char* kind,
                  const char* subfolder, const std::string& name) {
  const SourcePlace& place = document.place(kind, name);
  std::string text = fmt::format("\\LiterateProvenance{{{}}}{{{}}}{{{}}}{{{}}}{{", kind, name,
                                 escape_latex_path(text_of(place)), breakable(place.function));
  for (const std::string& file : data_files(folder / subfolder, name)) {
    text += fmt::format("%\n  \\LiterateFile{{{}/{}}}{{{}}}", subfolder, file,
                        sys::sha256_of_file(folder / subfolder / file));
  }
  return text + "}\n";
}

}  // namespace

std::string provenance_tex(const Document& document, const fs::path& folder) {
  std::string text;
  for (const auto& [name, figure] : document.figures()) {
    text += entry(document, folder, "figure", "figures", name);
  }
  for (const auto& [name, table] : document.tables()) {
    text += entry(document, folder, "table", "tables", name);
  }
  return text + document.attachments().latex("imports");
}

}  // namespace literate

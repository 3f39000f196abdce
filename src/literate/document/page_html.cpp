// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/page_html.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "literate/document/document_tex.hpp"
#include "literate/text/latex.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

std::string tex(const std::string& latex) {
  return "<tex>" + latex + "</tex>";
}

std::string plain(const std::string& text) {
  return tex(escape_latex(text));
}

std::string code(const std::string& text) {
  return "<code>" + tex(escape_latex(text)) + "</code>";
}

/// Three cells of the i-th row, from 1: what was found, the limit, the margin and the limit's age.
std::string criterion_html(const Criterion& criterion, const std::string& letter, Verdict verdict,
                           std::size_t i) {
  const std::string outcome(name_of(criterion.outcome()));
  std::string html = fmt::format(
      "<td data-outcome=\"{}\">{}: <strong>{}</strong></td>"
      "<td>{} <a class=\"lit-limit\" href=\"#limit-{}\">[{}]</a></td><td>{}",
      outcome, plain(criterion.name()), tex(criterion.found().latex), tex(criterion.limit().latex),
      letter, letter, plain(criterion.margin().text()));
  const bool all_alike = verdict == Verdict::confirmed || verdict == Verdict::refuted;
  if (outcome == "undecided") {
    html += ", undecided: " + plain(criterion.missing());
  } else if (!all_alike) {
    html += ", " + outcome;
  }
  return html + fmt::format("@age:{}@</td>", i);
}

std::string error_of(const Value& value) {
  const std::string error = error_tex(value);
  return error.empty() ? "" : ", " + tex(error);
}

}  // namespace

std::string claim_html(const Registered& registered, const LimitNotes& notes, const std::string& id,
                       const Claim& claim) {
  const SourcePlace& place = registered.places.at({"claim", id});
  const std::string found(name_of(claim.found()));
  const std::string expected(name_of(claim.expected));
  const std::size_t n_rows = claim.criteria.size();
  std::string html = fmt::format(
      "<article class=\"lit-ledger-entry\" id=\"claim-{0}\" data-claim=\"{0}\" "
      "data-verdict=\"{1}\" data-origin=\"@origin@\">\n<table class=\"lit-entry\"><tbody>\n"
      "<tr><td rowspan=\"{2}\"><p class=\"lit-ledger-statement\"><span class=\"lit-number\">"
      "<tex>\\LedgerNumber{{{0}}}</tex></span> <em><tex>\\LedgerSentence{{{0}}}</tex></em> "
      "<span class=\"lit-ledger-source\"><tex>\\LedgerSource{{{0}}}</tex></span></p>\n",
      id, found.substr(0, found.find(' ')), n_rows);
  html += fmt::format(
      "<p class=\"lit-ledger-route\">Tested: {}. <span class=\"lit-ledger-place\">{}, {}, "
      "@uses:claim:{}@</span></p></td>\n",
      plain(claim.route), code(id), code(text_of(place)), id);
  const std::string decided = fmt::format(
      "\n<td rowspan=\"{}\"><p><strong class=\"lit-verdict\" data-verdict=\"{}\">"
      "<tex>\\verdictsign{{{}}}</tex> {}</strong>{}</p>"
      "<p class=\"lit-severity\">{}</p></td>",
      n_rows, found.substr(0, found.find(' ')), found, found,
      found == expected ? "" : ", <strong>not " + expected + " as expected</strong>",
      severity_text(registered, id));
  for (std::size_t i = 0; i < n_rows; ++i) {
    const Criterion& criterion = claim.criteria[i];
    html += (i == 0 ? "" : "<tr>") +
            criterion_html(criterion, notes.letter_of(criterion), claim.found(), i + 1) +
            (i == 0 ? decided : "") + "</tr>\n";
  }
  return html + "</tbody></table>\n</article>\n";
}

std::string limits_html(const LimitNotes& notes) {
  std::string html = "<ul class=\"lit-limits\">\n";
  for (const LimitNotes::Note& note : notes.notes()) {
    html += fmt::format("<li id=\"limit-{0}\"><strong>[{0}]</strong> <em>{1}:</em> {2}</li>\n",
                        note.letter, name_of(note.kind), plain(note.reason));
  }
  return html + "</ul>\n";
}

std::string lettered(const std::string& claim_html, std::vector<std::string>& order) {
  static const sys::Pattern link(R"re((href="#limit-([a-z]+)">\[)[a-z]+\])re");
  std::string html;
  std::string_view rest = claim_html;
  for (const sys::Pattern::Match& found : link.all_in(claim_html)) {
    const auto known = std::ranges::find(order, found.parts[2]);
    const auto index = static_cast<std::size_t>(known - order.begin());
    if (known == order.end()) order.push_back(found.str(2));
    html += std::string(found.before) + found.str(1) + letter_of_index(index) + "]";
    rest = found.rest;
  }
  return html.append(rest);
}

std::string in_order(const std::string& limits_html, const std::vector<std::string>& order) {
  std::string html = "<ul class=\"lit-limits\">\n";
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::string begin = fmt::format("<li id=\"limit-{}\"><strong>[", order[i]);
    const auto at = limits_html.find(begin);
    if (at == std::string::npos) throw std::out_of_range("no note has the letter " + order[i]);
    const auto behind = limits_html.find(']', at);
    html += begin + letter_of_index(i) +
            limits_html.substr(behind, limits_html.find('\n', at) + 1 - behind);
  }
  return html + "</ul>\n";
}

std::string index_html(const Registered& registered) {
  std::string html = "<div class=\"lit-index\">\n";
  for (const auto& [key, value] : registered.values) {
    html += fmt::format("<p id=\"val-{}\">{}: {}{}; {}; @uses:val:{}@</p>\n", key, code(key),
                        tex(value.latex()), error_of(value),
                        code(text_of(registered.places.at({"value", key}))), key);
  }
  return html + "</div>\n";
}

std::string provenance_html(const Registered& registered, const fs::path& folder) {
  std::string html = "<div class=\"lit-provenance\">\n";
  const auto add = [&](const std::string& kind, const std::string& name, const std::string& files) {
    const SourcePlace& place = registered.places.at({kind, name});
    html +=
        fmt::format("<p><strong>{} {}</strong>, @uses:{}:{}@: {}, {}{}</p>\n", kind, plain(name),
                    kind, name, code(text_of(place)), code(place.function), tex(files));
  };
  for (const auto& [name, figure] : registered.figures) {
    add("figure", name, fmt::format("\\LiterateFiles{{figures/{}/files.tex}}", name));
  }
  for (const auto& [name, table] : registered.tables) {
    const std::string file = fmt::format("tables/{}.csv", name);
    add("table", name,
        fmt::format("\\LiterateFile{{{}}}{{{}}}", file, sys::sha256_of_file(folder / file)));
  }
  return html + "<p>" + tex(registered.attachments.latex("imports")) + "</p></div>\n";
}

void write_page_parts(const Registered& registered, const fs::path& folder) {
  const fs::path page = folder / "page";
  for (const auto& [name, table] : registered.tables) {
    sys::write_file_atomically(page / "tables" / (name + ".html"), table.html());
  }
  const LimitNotes notes(registered);
  for (const auto& [id, claim] : registered.claims) {
    sys::write_file_atomically(page / "claims" / (id + ".html"),
                               claim_html(registered, notes, id, claim));
  }
  sys::write_file_atomically(page / "limits.html", limits_html(notes));
  sys::write_file_atomically(
      page / "faults.html",
      registered.severity ? "<p>" + registered.severity->summary() + "</p>\n" : "");
  sys::write_file_atomically(page / "index.html", index_html(registered));
  sys::write_file_atomically(page / "provenance.html", provenance_html(registered, folder));
}

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "literate/page/highlight.hpp"
#include "literate/page/html_text.hpp"
#include "literate/page/page_writer.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

// A variant of a value by the options of its \val, without blanks: period[digits=3].
std::string variant(const std::string& key, const std::optional<PageTokens>& options) {
  if (!options) return key;
  std::string written = latex_of_tokens(*options);
  std::erase(written, ' ');
  std::erase(written, '{');
  std::erase(written, '}');
  return written.empty() ? key : key + "[" + written + "]";
}

// The day of an instant in words: 2026-11-05T12:00:00Z is 5 November 2026. What is no instant stays
// as it is.
std::string day_of(const std::string& date) {
  static constexpr std::array<std::string_view, 12> months{
      "January", "February", "March",     "April",   "May",      "June",
      "July",    "August",   "September", "October", "November", "December"};
  if (date.size() < 11 || date[4] != '-' || date[7] != '-' || date[10] != 'T') return date;
  const int month = std::atoi(date.substr(5, 2).c_str());
  if (month < 1 || month > 12) return date;
  return fmt::format("{} {} {}", std::atoi(date.substr(8, 2).c_str()),
                     months.at(static_cast<std::size_t>(month) - 1), date.substr(0, 4));
}

}  // namespace

// What generated files define.
void PageWriter::define_name(const PageToken& token) {
  const std::string& name = token.text;
  if (name == "LiterateValue") {
    const std::string key = reader_.text_argument();
    values_[key] = reader_.argument();
    reader_.argument();
  } else if (name == "LiterateRaw") {
    const std::string key = reader_.text_argument();
    raw_values_[key] = reader_.argument();
  } else if (name == "LiterateRestyled" || name == "LiterateRestyledRaw") {
    std::string key = reader_.text_argument();
    std::string options = latex_of_tokens(reader_.argument());
    for (const char c : {' ', '{', '}'}) std::erase(options, c);
    key += options;
    (name == "LiterateRestyled" ? values_ : raw_values_)[key] = reader_.argument();
    if (name == "LiterateRestyled") reader_.argument();
  } else if (name == "LiterateFlag") {
    const std::string key = reader_.text_argument();
    flags_[key] = reader_.text_argument() == "true";
  } else if (name == "LiterateClaim") {
    const std::string key = reader_.text_argument();
    claims_[key].verdict = reader_.text_argument();
  } else if (name == "LiterateStatement") {
    Claim& claim = claims_[reader_.text_argument()];
    claim.number = reader_.text_argument();
    claim.part = reader_.text_argument();
    claim.source = latex_of_tokens(reader_.argument());
    claim.sentence = latex_of_tokens(reader_.argument());
  } else if (name == "LiterateCount") {
    const std::string part = reader_.text_argument();
    const std::string verdict = reader_.text_argument();
    claim_counts_[part + "@" + verdict] = reader_.text_argument();
  } else if (name == "LiterateQuotation") {
    const std::string key = reader_.text_argument();
    quoted_pages_[key] = reader_.argument();
    quotations_[key] = reader_.argument();
  } else {  // \LiterateStamp
    const std::string words = inline_html(reader_.argument());
    out_ = "<p class=\"lit-stamp\" role=\"alert\"><strong>" + words + "</strong></p>\n" + out_;
  }
}

// Marks a use of a name, so that the ledger and the index can lead to it: the attribute of its id.
std::string PageWriter::use(const std::string& what) {
  std::vector<Use>& uses = uses_[what];
  const int section = headings_.empty() ? -1 : static_cast<int>(headings_.size()) - 1;
  std::string id = "use-" + replaced(what, "@", "-") + "-" + std::to_string(uses.size() + 1);
  uses.push_back({id, section});
  return " id=\"" + id + "\"";
}

// «used in § 4, Findings»: each section once.
std::string PageWriter::uses_text(const std::string& what) const {
  const auto found = uses_.find(what);
  if (found == uses_.end()) return "";
  std::string text = "used in ";
  std::set<int> told;
  for (const Use& use : found->second) {
    if (!told.insert(use.section).second) continue;
    std::string where = "the beginning";
    if (use.section >= 0) {
      // A subsection without a number is told by the section above it.
      auto index = static_cast<std::size_t>(use.section);
      while (index > 0 && headings_[index].number.empty() && headings_[index].level > 1) --index;
      const Heading& heading = headings_[index];
      where = heading.number.empty() ? without_links(heading.title) : "§ " + heading.number;
      if (!told.insert(1000000 + static_cast<int>(index)).second) continue;
    }
    if (!text.ends_with("in ")) text += ", ";
    text += "<a class=\"lit-ref\" href=\"#" + use.id + "\">" + where + "</a>";
  }
  return text;
}

void PageWriter::value(const PageToken& token) {
  const auto options = reader_.optional_argument();
  const std::string key = reader_.text_argument();
  if (is_preamble_) return;
  const auto found = values_.find(variant(key, options));
  if (found == values_.end()) {
    return complain(token, "{" + key + "}: there is no value of this name");
  }
  const bool was_code = is_code_;
  const std::string shown = inline_html(found->second);
  is_code_ = was_code;
  html("<span class=\"lit-value\" data-key=\"" + escape_html(key) + "\"" + use("val@" + key) + ">" +
       mark('v', key + "\n" + shown) + "</span>");
}

void PageWriter::raw_value(const PageToken& token) {
  const auto options = reader_.optional_argument();
  const std::string key = reader_.text_argument();
  const auto found = raw_values_.find(variant(key, options));
  if (found == raw_values_.end()) {
    return complain(token, "{" + key + "}: there is no number of this name");
  }
  text(latex_of_tokens(found->second));
}

void PageWriter::flag(const PageToken& token) {
  const std::string key = reader_.text_argument();
  const PageTokens yes = reader_.argument();
  const PageTokens no = reader_.argument();
  const auto found = flags_.find(key);
  if (found == flags_.end()) {
    return complain(token, "{" + key + "}: there is no flag of this name");
  }
  reader_.push(found->second ? yes : no);
}

void PageWriter::statement(const PageToken&) {
  reader_.optional_argument();
  reader_.argument();
  reader_.argument();
}

std::string PageWriter::short_verdict(const std::string& verdict) {
  return verdict == "partly confirmed" ? "partly" : verdict;
}

std::string PageWriter::sign_of(const std::string& verdict) {
  std::string sign = "?";
  if (verdict == "confirmed") sign = "✓";
  if (verdict == "partly confirmed") sign = "◐";
  if (verdict == "refuted") sign = "✗";
  return sign;
}

std::string PageWriter::claim_mark(const std::string& key, bool is_in_table) {
  const Claim& claim = claims_[key];
  return fmt::format(
      "<a class=\"lit-claim{0}\"{1} data-claim=\"{2}\" data-verdict=\"{3}\"{4} aria-label=\"claim "
      "{5}, "
      "{6}\"><span class=\"lit-sign\" data-verdict=\"{3}\" "
      "aria-hidden=\"true\">{7}</span>\u202F{5}</a>",
      is_in_table ? " lit-in-table" : "", use("claim@" + key), escape_html(key),
      short_verdict(claim.verdict), mark('l', "claim-" + key), claim.number, claim.verdict,
      sign_of(claim.verdict));
}

void PageWriter::claim(const PageToken& token) {
  const std::string key = reader_.text_argument();
  if (is_preamble_) return;
  if (!claims_.contains(key)) {
    return complain(token, "{" + key + "}: there is no claim of this name");
  }
  html(claim_mark(key, false));
}

void PageWriter::claim_count(const PageToken& token) {
  const std::string part = reader_.text_argument();
  const std::string verdict = reader_.text_argument();
  const auto found = claim_counts_.find(part + "@" + verdict);
  if (found == claim_counts_.end()) {
    return complain(token, "{" + part + "}{" + verdict + "}: there is no such count");
  }
  text(found->second);
}

void PageWriter::finding_says(const PageToken& token) {
  const std::string key = reader_.text_argument();
  finding_words_[key] = reader_.argument();
  if (!claims_.contains(key)) complain(token, "{" + key + "}: there is no claim of this name");
}

void PageWriter::limit_kind(const PageToken& token) {
  const std::string name = reader_.text_argument();
  const PageTokens shown = reader_.argument();
  const auto known = limit_kinds_.find(name);
  if (known == limit_kinds_.end()) {
    return complain(token, "{" + name + "}: there is no kind of limit of this name");
  }
  known->second = shown;
}

void PageWriter::verdict_sign(const PageToken&) {
  const std::string verdict = reader_.text_argument();
  html("<span class=\"lit-sign\" data-verdict=\"" + short_verdict(verdict) +
       "\" aria-hidden=\"true\">" + sign_of(verdict) + "</span>");
}

void PageWriter::quoted(const PageToken& token) {
  const std::string key = reader_.text_argument();
  const bool is_page = token.text == "quotedpage";
  const auto& known = is_page ? quoted_pages_ : quotations_;
  const auto found = known.find(key);
  if (found == known.end()) {
    return complain(token, "{" + key + "}: there is no quotation of this name");
  }
  if (is_page) return text("p.\u00A0" + plain_text(found->second));
  html("<span class=\"lit-quoted\">“" + inline_html(found->second) + "”</span>");
}

void PageWriter::ledger(const PageToken&) {
  const auto file = found_file("claims.tex", "");
  if (is_preamble_ || !file) return;
  const PageTokens entries = file_tokens(*file, true);
  for (const std::string part : {"cited", "own"}) {
    const auto count = [&](const std::string& verdict) {
      const auto found = claim_counts_.find(part + "@" + verdict);
      return found == claim_counts_.end() ? "0" : found->second;
    };
    if (count("all") == "0") continue;
    ledger_part_ = part;
    const std::string name =
        inline_html(page_tokens(part == "cited" ? "\\LiterateCitedName" : "\\LiterateOwnName"));
    const std::string unexpected = count("unexpected") == "0" ? "."
                                                              : "; <strong>" + count("unexpected") +
                                                                    " not as expected</strong>.";
    block(
        fmt::format("<section class=\"lit-ledger\" data-origin=\"{}\">\n<p "
                    "class=\"lit-ledger-count\"><strong>{}</strong>: {}, of which {} confirmed, {} "
                    "partly confirmed, {} refuted and {} undecided{}</p>\n",
                    part == "cited" ? "paper" : "ours", name, count("all"), count("confirmed"),
                    count("partly confirmed"), count("refuted"), count("undecided"), unexpected));
    block(block_html(entries));
    block("</section>\n");
  }
}

void PageWriter::ledger_entry(const PageToken&) {
  const std::string key = reader_.text_argument();
  const PageTokens route = reader_.argument();
  const std::string expected = reader_.text_argument();
  const std::string found = reader_.text_argument();
  const PageTokens place = reader_.argument();
  const PageTokens criteria = reader_.argument();
  const Claim& claim = claims_[key];
  if (claim.part != ledger_part_) return;
  printed_.insert("claim-" + key);
  const std::string source = inline_html(page_tokens(claim.source));
  block(fmt::format(
      "<article class=\"lit-ledger-entry\" id=\"claim-{0}\" data-claim=\"{0}\" "
      "data-verdict=\"{1}\" "
      "data-origin=\"{2}\">\n<p class=\"lit-ledger-statement\"><span "
      "class=\"lit-number\">{3}</span> "
      "<em>{4}</em>{5} <strong class=\"lit-verdict\" data-verdict=\"{1}\">{6}{7}</strong></p>\n",
      key, short_verdict(found), claim.part == "cited" ? "paper" : "ours", claim.number,
      inline_html(page_tokens(claim.sentence)),
      source.empty() ? "" : " <span class=\"lit-ledger-source\">(" + source + ")</span>", found,
      expected == found ? "" : ", not " + expected + " as expected"));
  block("<p class=\"lit-ledger-route\"><em>Route:</em> " + inline_html(route) +
        ". <span class=\"lit-ledger-place\"><code>" + plain_text(place) + "</code>" +
        mark('u', "claim@" + key) + "</span></p>\n<ul class=\"lit-criteria\">\n" +
        block_html(criteria) + "</ul>\n</article>\n");
}

// The kind of a limit as the document prints it: a letter that says its name where one points at
// it, or the name.
std::string PageWriter::limit_kind_html(const std::string& name) {
  const auto shown = limit_kinds_.find(name);
  if (shown == limit_kinds_.end() || shown->second.empty()) return escape_html(name) + ":";
  return "<abbr title=\"" + escape_html(name) + "\">" + inline_html(shown->second) + "</abbr>";
}

void PageWriter::criterion(const PageToken&) {
  const std::string name = inline_html(reader_.argument());
  const std::string computed = inline_html(reader_.argument());
  // A short limit, «[≤ 0.1 %», stays on one line.
  std::string asked = "[" + inline_html(reader_.argument());
  if (text_of_html(asked).size() <= 30) asked = "<span class=\"lit-nowrap\">" + asked + "</span>";
  const std::string kind = reader_.text_argument();
  const std::string reason = inline_html(reader_.argument());
  const std::string outcome = reader_.text_argument();
  const std::string undecided = inline_html(reader_.argument());
  std::string told = "Holds in part.";
  if (outcome == "holds") told = "Holds.";
  if (outcome == "fails") told = "Fails.";
  if (outcome == "undecided") told = "Undecided: " + undecided + ".";
  block(
      fmt::format("<li data-outcome=\"{}\">{}: <strong>{}</strong> {}, {} {}]. <span "
                  "class=\"lit-outcome\">{}</span></li>\n",
                  outcome, name, computed, asked, limit_kind_html(kind), reason, told));
}

void PageWriter::value_index(const PageToken&) {
  const auto file = found_file("index.tex", "");
  if (is_preamble_ || !file) return;
  block("<dl class=\"lit-index\">\n" + block_html(file_tokens(*file, true)) + "</dl>\n");
}

void PageWriter::index_entry(const PageToken&) {
  const std::string key = reader_.text_argument();
  reader_.argument();
  const std::string error = inline_html(reader_.argument());
  const std::string place = plain_text(reader_.argument());
  const PageTokens own = reader_.argument();
  printed_.insert("val-" + key);
  block(
      fmt::format("<dt id=\"val-{0}\"><code>{0}</code></dt>\n<dd>{1}{2}; <code "
                  "class=\"lit-place\">{3}</code>{4}</dd>\n",
                  escape_html(key), inline_html(own.empty() ? values_[key] : own),
                  error.empty() ? "" : ", " + error, escape_html(place), mark('u', "val@" + key)));
}

void PageWriter::provenance(const PageToken&) {
  const auto file = found_file("provenance.tex", "");
  if (is_preamble_ || !file) return;
  block("<div class=\"lit-provenance\">\n" + block_html(file_tokens(*file, true)) + "</div>\n");
}

void PageWriter::provenance_entry(const PageToken& token) {
  if (token.text == "LiterateFiles") {
    const auto file = found_file(reader_.text_argument(), "");
    if (file) reader_.push(file_tokens(*file, true));
    return;
  }
  if (token.text == "LiterateFile") {
    const std::string name = reader_.text_argument();
    const std::string digest = reader_.text_argument();
    return block("<li><code>" + escape_html(name) + "</code> <code class=\"lit-digest\">" +
                 escape_html(digest) + "</code></li>\n");
  }
  const std::string kind = reader_.text_argument();
  const std::string name = reader_.text_argument();
  const std::string shown = inline_html(reader_.argument());
  const std::string place = plain_text(reader_.argument());
  const std::string function = plain_text(reader_.argument());
  const std::string files = block_html(reader_.argument());
  const std::string id = kind + "-" + name;
  printed_.insert("source-" + id);
  block(
      fmt::format("<section id=\"source-{}\">\n<p><strong>{} {}</strong>{}: <code "
                  "class=\"lit-place\">{}</code>, <code>{}</code></p>\n{}</section>\n",
                  id, kind, shown, mark('u', kind + "@" + name), escape_html(place),
                  escape_html(function), files.empty() ? "" : "<ul>\n" + files + "</ul>\n"));
}

void PageWriter::repository(const PageToken&) {
  const PageTokens commit = reader_.argument();
  const bool is_modified = reader_.text_argument() == "true";
  const PageTokens date = reader_.argument();
  reader_.define("papercommit", {.pattern = {}, .body = commit});
  reader_.define("paperdate", {.pattern = {}, .body = date});
  reader_.define("paperday", {.pattern = {}, .body = page_tokens(day_of(latex_of_tokens(date)))});
  const PageTokens both = page_tokens("#1#2");
  PageMacro modified;
  modified.pattern = both;
  modified.body = {is_modified ? both[0] : both[1]};
  reader_.define("ifpapermodified", modified);
}

// \fig[width=…]{name}
void PageWriter::figure(const PageToken& token) {
  reader_.optional_argument();
  const std::string name = reader_.text_argument();
  if (is_preamble_) return;
  if (!found_file("figures/" + name + "/" + name + ".tex", "")) {
    return complain(token, "{" + name + "}: there is no figure of this name");
  }
  page_.figures.push_back(name);
  const std::string anchor = use("figure@" + name);
  const std::string image = fmt::format(
      "<img class=\"lit-drawing\"{} data-drawing=\"{}\" src=\"figures/{}.svg\" alt=\"{}\">", anchor,
      escape_html(name), escape_html(name),
      float_ ? mark('a', std::to_string(float_->text)) : "figure " + escape_html(name));
  if (float_ != nullptr) {
    if (float_->figure.empty()) float_->figure = name;
    return block(image + "\n");
  }
  block("<figure class=\"lit-figure\" data-figure=\"" + escape_html(name) + "\">\n" + image +
        "\n</figure>\n");
}

// \image[…]{file} and \includegraphics[…]{file}: a picture that no program made.
void PageWriter::picture(const PageToken& token) {
  reader_.star();
  reader_.optional_argument();
  const std::string name = reader_.text_argument();
  if (is_preamble_) return;
  std::string file = name;
  for (const char* ending : {"", ".pdf", ".png", ".jpg", ".jpeg", ".svg"}) {
    if (std::filesystem::is_regular_file(sources_.document / (name + ending))) {
      file = name + ending;
      break;
    }
  }
  if (!std::filesystem::is_regular_file(sources_.document / file)) {
    return complain(token, "{" + name + "}: there is no picture of this name");
  }
  page_.pictures.push_back(file);
  html("<img class=\"lit-picture\" src=\"pictures/" + escape_html(file) + "\" alt=\"" +
       (float_ ? mark('a', std::to_string(float_->text)) : escape_html(name)) + "\">");
}

// \excerpt[caption]{name}
void PageWriter::excerpt(const PageToken& token) {
  const auto said = reader_.optional_argument();
  const std::string name = reader_.text_argument();
  const auto file = found_file("excerpts/" + name + ".tex", "");
  if (!file) return complain(token, "{" + name + "}: there is no excerpt of this name");
  said_ = said ? inline_html(*said) + ". " : "";
  reader_.push(file_tokens(*file, true));
}

void PageWriter::listing(const PageToken&) {
  const std::string name = reader_.text_argument();
  const PageTokens file_name = reader_.argument();
  const std::string first = reader_.text_argument();
  const std::string last = reader_.text_argument();
  const std::string language = reader_.text_argument();
  const std::string file = plain_text(file_name);
  const std::string code = sys::read_file(sources_.generated / "excerpts" / (name + ".txt"));
  const int number = ++counters_["lstlisting"];
  const int id = new_id("listing-" + name);
  id_labels_[static_cast<std::size_t>(id)] = "lst:" + name;
  labels_["lst:" + name] = {"lstlisting", std::to_string(number), "", id};
  const std::string lines =
      first == last ? "line\u00A0" + first : "lines\u00A0" + first + "–" + last;
  std::string place = "<code>" + escape_html(file) + "</code>, " + lines;
  if (reader_.knows("LiterateSourceUrl")) {
    const std::string address = replaced(
        plain_text(page_tokens("\\LiterateSourceUrl{\\papercommit}{" + file + "}{" + first + "}")),
        "\\", "");
    if (!address.empty()) {
      place = "<a class=\"lit-link\" href=\"" + escape_html(address) + "\">" + place + "</a>";
    }
  }
  block(
      fmt::format("<figure class=\"lit-listing\" id=\"{}\" data-listing=\"{}:{}-{}\" "
                  "data-language=\"{}\">\n<figcaption><span class=\"lit-label\">{} {}</span>: "
                  "{}{}</figcaption>\n<pre tabindex=\"0\"><code>{}</code></pre>\n</figure>\n",
                  id_mark(id), escape_html(file), first, last, escape_html(language_name(language)),
                  plain_text(page_tokens("\\lstlistingname")), number, said_, place,
                  highlighted(code, language, std::stoi(first))));
  said_.clear();
}

}  // namespace literate

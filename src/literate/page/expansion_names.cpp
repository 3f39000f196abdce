// SPDX-License-Identifier: GPL-3.0-or-later
// What the document and the engine define: macros, conditions, values, claims, tables, figures.
#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>

#include "literate/page/expansion.hpp"
#include "literate/page/expansion_reading.hpp"
#include "literate/page/html_text.hpp"
#include "literate/prose/restyle.hpp"
#include "literate/text/characters.hpp"
#include "literate/text/latex.hpp"
#include "literate/values/decimal.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"

namespace literate {
namespace fs = std::filesystem;
using namespace page_reading;
namespace {

std::string command_in(std::string_view argument) {
  argument = sys::stripped(argument);
  return std::string(argument.substr(argument.starts_with('\\') ? 1 : 0));
}

std::string_view sign_of(std::string_view verdict) {
  if (verdict == "confirmed") return "✓";
  if (verdict == "refuted") return "✗";
  return verdict == "undecided" ? "?" : "◐";
}

/// A length in points, as TeX reads it; none if its unit depends on the page.
std::optional<double> length_in_points(std::string_view text) {
  static const std::map<std::string, double, std::less<>> units{{"pt", 1},
                                                                {"in", 72.27},
                                                                {"cm", 72.27 / 2.54},
                                                                {"mm", 7.227 / 2.54},
                                                                {"pc", 12},
                                                                {"bp", 72.27 / 72},
                                                                {"sp", 1 / 65536.0},
                                                                {"dd", 1238 / 1157.0},
                                                                {"cc", 14856 / 1157.0}};
  const std::string number(sys::stripped(text));
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  const auto unit = units.find(sys::stripped(end));
  if (end == number.c_str() || unit == units.end()) return std::nullopt;
  return value * unit->second;
}

std::optional<double> whole_number(std::string_view text) {
  const std::string number(sys::stripped(text));
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  if (end == number.c_str() || !sys::stripped(end).empty()) return std::nullopt;
  return value;
}

}  // namespace

// [2][default]{body}
Expander::Macro Expander::macro_at(TexScanner& in) const {
  Macro macro;
  if (const auto n = option(in)) macro.n_arguments = static_cast<std::size_t>(n->front() - '0');
  const auto first = option(in);
  macro.has_default = first.has_value();
  macro.first_default = first.value_or("");
  macro.body = argument(in);
  return macro;
}

void Expander::define(TexScanner& in, const TexToken& token) {
  const std::string name = command_in(argument(in));
  Macro macro = macro_at(in);
  const bool is_known = macros_.contains(name) || commands().contains(name);
  if (token.name == "providecommand" && is_known) return;
  macros_[name] = std::move(macro);
}

// \def\name#1#2{…}
void Expander::define_by_pattern(TexScanner& in, const TexToken&) {
  const std::string name = command_in(argument(in));
  const auto open = in.rest().find('{');
  if (open == in.rest().npos) return;
  const std::string_view pattern = in.skip(open);
  Macro macro;
  macro.n_arguments = static_cast<std::size_t>(std::ranges::count(pattern, '#'));
  macro.body = argument(in);
  if (pattern.size() == 2 * macro.n_arguments) macros_[name] = std::move(macro);
}

void Expander::define_environment(TexScanner& in, const TexToken&) {
  const std::string name(argument(in));
  Macro macro = macro_at(in);
  macro.end = argument(in);
  own_environments_[name] = std::move(macro);
}

void Expander::define_theorem(TexScanner& in, const TexToken& token) {
  const std::string name(argument(in));
  const auto shared = option(in);
  const std::string title(argument(in));
  option(in);
  theorems_[name] = {title, shared ? std::string(*shared) : name, !token.text.ends_with('*')};
}

void Expander::define_operator(TexScanner& in, const TexToken& token) {
  const std::string name = command_in(argument(in));
  const char* star = token.text.ends_with('*') ? "*" : "";
  macros_[name] = {.body = fmt::format("\\operatorname{}{{{}}}", star, argument(in))};
}

void Expander::set_picture(TexScanner& in, const TexToken&) {
  picture_environments_.emplace(argument(in));
}

void Expander::document_class(TexScanner& in, const TexToken&) {
  option(in);
  class_ = argument(in);
  // Without a \\date these classes print today's.
  if (class_ == "article" || class_ == "report") metadata_["date"] = "\\today";
  if (class_ == "report" || class_ == "book") macros_["refname"] = {.body = "\\bibname"};
  sorts_citations_ = compresses_citations_ = class_.starts_with("revtex");
}

// A package of the document's own folder is part of the document.
void Expander::package(TexScanner& in, const TexToken&) {
  const std::string_view options = option(in).value_or("");
  const std::string name(argument(in));
  const auto has = [&](const char* wanted) { return options.find(wanted) != options.npos; };
  for (const std::string& one : names_in(name)) {
    if (one == "natbib") {
      is_author_year_ = !has("numbers") && !has("super");
      has_round_citations_ = has("round") || (is_author_year_ && !has("square"));
      sorts_citations_ = has("sort");
      compresses_citations_ = has("compress") && !is_author_year_;
    }
    if (one == "cite") {
      sorts_citations_ = !has("nosort");
      compresses_citations_ = !has("nocompress");
    }
  }
  const fs::path file = sources_.document / (name + ".sty");
  if (fs::is_regular_file(file)) read_preamble(sys::read_file(file));
}

// What is between \makeatletter and \makeatother concerns LaTeX.
void Expander::letter_region(TexScanner& in, const TexToken&) {
  while (const auto token = in.next()) {
    if (token->name == "makeatother") return;
  }
}

// \ifdim1cm>10pt … \else … \fi and the like; \iftrue and \iffalse.
void Expander::condition(TexScanner& in, const TexToken& token) {
  const std::string kind(token.name);
  bool is_true = kind == "iftrue";
  if (kind == "ifdim" || kind == "ifnum") {
    // Both sides may be commands; the second ends at a blank, or where no length goes on.
    std::string both;
    std::string* const outer = std::exchange(out_, &both);
    while (true) {
      const TexScanner before = in;
      const auto part = in.next();
      if (!part) break;
      const bool is_number = part->name == "rawval" || macros_.contains(part->name);
      if (part->kind == TexKind::command && is_number) {
        read(in, *part);
        continue;
      }
      if (part->kind != TexKind::text) {
        if (part->name != "relax") in = before;
        break;
      }
      const auto relation = part->text.find_first_of("<=>");
      const auto known = both.find_first_of("<=>");
      const bool is_second = known != both.npos;
      const bool has_begun = is_second && known + 1 < both.size();
      const auto from =
          has_begun ? 0 : part->text.find_first_not_of(" \t\n", is_second ? 0 : relation + 1);
      const auto end = !is_second && relation == part->text.npos ? part->text.npos
                       : from == part->text.npos                 ? from
                                                 : part->text.find_first_of(" \t\n", from);
      both += part->text.substr(0, end);
      if (end == part->text.npos) continue;
      in = before;
      in.skip(end + 1);
      break;
    }
    out_ = outer;
    const auto relation = std::min(both.find_first_of("<=>"), both.size());
    const auto parsed = kind == "ifdim" ? length_in_points : whole_number;
    const auto left = parsed(std::string_view(both).substr(0, relation));
    const auto right = parsed(std::string_view(both).substr(std::min(relation + 1, both.size())));
    if (!left || !right) {
      return fail(fmt::format("the page cannot decide \\{}{}", kind, both));
    }
    const char sign = both[relation];
    is_true = sign == '<'   ? *left < *right
              : sign == '>' ? *left > *right
                            : std::abs(*left - *right) < 1e-6;
  }
  std::string yes, no;
  bool in_else = false;
  for (int depth = 1; auto part = in.next();) {
    const bool opens = part->kind == TexKind::command && part->name.starts_with("if") &&
                       part->name != "ifflag" && part->name != "ifpapermodified";
    if (opens) ++depth;
    if (part->name == "fi" && --depth == 0) break;
    if (part->name == "else" && depth == 1) {
      in_else = true;
      continue;
    }
    (in_else ? no : yes) += part->text;
  }
  read_all(is_true ? yes : no);
}

void Expander::value(TexScanner& in, const TexToken&) {
  const std::string options(option(in).value_or(""));
  const std::string key(argument(in));
  if (!names_.values.contains(key)) return fail(fmt::format("unknown value '{}'", key));
  std::string printed = registered_.at("values").at(key).at("printed");
  if (!options.empty()) {
    try {
      printed = restyled(names_.numbers.at(key), options).printed();
    } catch (const std::exception& error) {
      return fail(error.what());
    }
  }
  printed = boost::replace_all_copy(printed, "\\%", "%");
  const bool is_number = names_.numbers.contains(key);
  const std::string latex =
      is_number ? quantity_latex(printed, is_math_) : expanded(escape_latex(printed));
  const std::string id = use_id("val", key);
  if (is_math_) return emit(latex);
  emit(marked(fmt::format("<span class=\"lit-value lit-nowrap\" data-key=\"{}\" id=\"{}\">"
                          "<a href=\"#val-{}\">",
                          key, id, key),
              latex, "</a></span>"));
}

void Expander::raw_value(TexScanner& in, const TexToken&) {
  const std::string options(option(in).value_or(""));
  const std::string key(argument(in));
  const auto number = names_.numbers.find(key);
  if (number == names_.numbers.end()) return fail(fmt::format("unknown number '{}'", key));
  try {
    emit(bare_digits(options.empty() ? number->second.number
                                     : restyled_number(number->second, options)));
  } catch (const std::exception& error) {
    fail(error.what());
  }
}

void Expander::flag(TexScanner& in, const TexToken&) {
  const std::string key(argument(in));
  const std::string_view yes = argument(in), no = argument(in);
  const auto found = names_.flags.find(key);
  if (found == names_.flags.end()) return fail(fmt::format("unknown flag '{}'", key));
  read_all(found->second ? yes : no);
}

void Expander::modified(TexScanner& in, const TexToken&) {
  const std::string_view yes = argument(in), no = argument(in);
  read_all(is_modified_ ? yes : no);
}

void Expander::repository(TexScanner& in, const TexToken&) {
  macros_["papercommit"] = {.body = std::string(argument(in))};
  is_modified_ = argument(in) == "true";
  const std::string date(argument(in));
  macros_["paperdate"] = {.body = date};
  constexpr std::string_view months[] = {"January",   "February", "March",    "April",
                                         "May",       "June",     "July",     "August",
                                         "September", "October",  "November", "December"};
  const bool is_day = date.size() >= 10 && is_digit(date[5]);
  macros_["paperday"] = {.body = date};
  if (!is_day) return;
  const int day = std::stoi(date.substr(8, 2));
  const std::string_view month = months[std::stoul(date.substr(5, 2)) - 1];
  const std::string year = date.substr(0, 4);
  macros_["paperday"] = {.body = fmt::format("{} {} {}", day, month, year)};
  macros_["today"] = {.body = fmt::format("{} {}, {}", month, day, year)};
}

void Expander::quoted(TexScanner& in, const TexToken& token) {
  const auto quotation = quotations_.find(std::string(argument(in)));
  if (quotation == quotations_.end()) return fail("unknown quotation");
  if (token.name == "quotedpage")
    return emit("p.~" + expanded(escape_latex(quotation->second.page)));
  emit(marked("<span class=\"lit-quoted\">", "``" + expanded(words_latex(quotation->second)) + "''",
              "</span>"));
}

void Expander::statement(TexScanner& in, const TexToken&) {
  option(in);
  argument(in);
  argument(in);
}

std::string Expander::claim_mark(const std::string& id) {
  const auto statement = statements_.find(id);
  if (statement == statements_.end()) {
    fail(fmt::format("unknown claim '{}'", id));
    return {};
  }
  const std::string found = names_.claims.at(id).found;
  const std::string number = statement->second.number;
  return marked(
      fmt::format("<a class=\"lit-claim\" id=\"{}\" data-claim=\"{}\" data-verdict=\"{}\" "
                  "aria-label=\"claim {}, {}\" href=\"#claim-{}\"><span aria-hidden=\"true\">{}"
                  "</span> ",
                  use_id("claim", id), id, one_word(found), number, found, id, sign_of(found)),
      number, "</a>");
}

void Expander::claim(TexScanner& in, const TexToken&) {
  emit(claim_mark(std::string(argument(in))));
}

void Expander::verdict_sign(TexScanner& in, const TexToken&) {
  const std::string verdict(argument(in));
  emit(marked(
      fmt::format(
          "<span class=\"lit-sign\" data-verdict=\"{}\" role=\"img\" aria-label=\"{}\">{}</span>",
          one_word(verdict), verdict, sign_of(verdict)),
      "", ""));
}

void Expander::claim_count(TexScanner& in, const TexToken&) {
  const bool is_cited = argument(in) == "cited";
  const std::string_view verdict = argument(in);
  emit(std::to_string(std::ranges::count_if(claim_order_, [&](const std::string& id) {
    const NamedClaim& claim = names_.claims.at(id);
    if (statements_.at(id).statement.source.empty() == is_cited) return false;
    if (verdict == "unexpected") return claim.found != claim.expected;
    return verdict == "all" || claim.found == verdict;
  })));
}

void Expander::finding_says(TexScanner& in, const TexToken&) {
  const std::string id(argument(in));
  findings_[id] = argument(in);
}

void Expander::findings(TexScanner& in, const TexToken& token) {
  const std::string_view body = body_of(in, token.name);
  std::string heads = macros_.at("LiterateFindingsHead").body;
  for (auto at = heads.find('&'); at != heads.npos; at = heads.find('&', at)) {
    heads.replace(at, 1, "</tex></th><th scope=\"col\"><tex>");
  }
  fragment(
      "<div class=\"lit-scroll\" tabindex=\"0\" role=\"group\" aria-label=\"findings\"><table "
      "class=\"lit-table lit-findings\"><thead><tr><th scope=\"col\"><tex>" +
      boost::replace_all_copy(heads, "<th scope=\"col\"><tex> </tex></th>", "<td></td>") +
      "</tex></th></tr></thead><tbody><tex>" + std::string(body) + "</tex></tbody></table></div>");
}

void Expander::finding(TexScanner& in, const TexToken&) {
  const std::string where(option(in).value_or(""));
  const std::string id(argument(in));
  const std::string found(argument(in));
  if (!statements_.contains(id)) return fail(fmt::format("unknown claim '{}'", id));
  const Statement& statement = statements_.at(id).statement;
  std::string says = findings_[id];
  if (says.empty()) {
    says = statement.sentence + (statement.source.empty() ? "" : " (" + statement.source + ")");
  }
  emit(marked("<tr><td class=\"lit-paragraph\">", expanded(says), ""));
  emit(marked("</td><td class=\"lit-paragraph\">", expanded(found), "</td><td>"));
  emit(claim_mark(id));
  emit(marked("</td><td>", expanded(where), "</td></tr>"));
}

void Expander::limit_kind(TexScanner& in, const TexToken&) {
  const std::string kind(argument(in));
  limits_[kind] = argument(in);
}

void Expander::limit(TexScanner& in, const TexToken&) {
  read_all(limits_[std::string(argument(in))]);
}

// The number, sentence or source of a claim in the ledger.
void Expander::sentence(TexScanner& in, const TexToken& token) {
  const NumberedStatement& claim = statements_.at(std::string(argument(in)));
  if (token.name == "LedgerNumber") return emit(claim.number);
  if (token.name == "LedgerSentence") return read_all(claim.statement.sentence);
  if (!claim.statement.source.empty()) read_all("(" + claim.statement.source + ")");
}

void Expander::ledger(TexScanner&, const TexToken&) {
  emit("\n\n");
  begin_block("<div class=\"lit-ledger\">", "</div>", false);
  ledger_part(true);
  ledger_part(false);
  end_block();
}

void Expander::ledger_part(bool is_cited) {
  const char* part = is_cited ? "cited" : "own";
  const char* name = is_cited ? "\\LiterateCitedName" : "\\LiterateOwnName";
  std::vector<std::string> ids;
  std::ranges::copy_if(claim_order_, std::back_inserter(ids), [&](const std::string& id) {
    return statements_.at(id).statement.source.empty() != is_cited;
  });
  if (ids.empty()) return;
  std::string head = fmt::format("\n\n\\textbf{{{}}}: {}, of which ", name, ids.size());
  for (const char* verdict : {"confirmed", "partly confirmed", "refuted", "undecided"}) {
    const char* comma = verdict[0] == 'c' ? "" : verdict[0] == 'u' ? " and " : ", ";
    head += fmt::format("{0}\\claimcount{{{1}}}{{{2}}} {2}", comma, part, verdict);
  }
  read_all(head + ".\n\n");
  for (const std::string& id : ids) {
    ids_.insert("claim-" + id);
    std::string html = sys::read_file(sources_.generated / "page/claims" / (id + ".html"));
    fragment(boost::replace_all_copy(html, "@origin@", is_cited ? "paper" : "ours"));
  }
}

void Expander::index(TexScanner&, const TexToken&) {
  for (const std::string& key : names_.values) ids_.insert("val-" + key);
  fragment(sys::read_file(sources_.generated / "page/index.html"));
}

void Expander::provenance(TexScanner&, const TexToken&) {
  fragment(sys::read_file(sources_.generated / "page/provenance.html"));
}

// The files of a drawing, which may be made again after the computation.
void Expander::provenance_file(TexScanner& in, const TexToken& token) {
  if (token.name == "LiterateFiles") {
    return read_all(sys::read_file(sources_.generated / std::string(argument(in))));
  }
  const std::string file(argument(in));
  emit(marked(fmt::format("<br><code>{}</code> <code class=\"lit-digest\">{}</code>",
                          escape_html(file), argument(in)),
              "", ""));
}

void Expander::table(TexScanner& in, const TexToken&) {
  const auto long_caption = option(in);
  const std::string name(argument(in));
  if (!names_.tables.contains(name)) return fail(fmt::format("unknown table '{}'", name));
  use_id("table", name);
  const bool breaks = long_caption && !long_caption->empty();
  if (breaks) {
    read_all(fmt::format("\\begin{{table}}\\caption{{{}}}", *long_caption));
  } else if (floats_.empty() && numbers_.next_is("table", "longtable")) {
    numbers_.take("table");  // a table over pages counts even without a caption
  }
  std::string html = sys::read_file(sources_.generated / "page/tables" / (name + ".html"));
  fragment(boost::replace_all_copy(html, "@use@", uses_[{"table", name}].back().id));
  if (breaks) read_all("\\end{table}");
}

void Expander::figure(TexScanner& in, const TexToken&) {
  option(in);
  const std::string name(argument(in));
  if (!names_.figures.contains(name)) return fail(fmt::format("unknown figure '{}'", name));
  result_.figures.push_back(name);
  emit(marked(fmt::format("<img class=\"lit-drawing\" id=\"{}\" data-drawing=\"{}\" "
                          "src=\"figures/{}.svg\" alt=\"@alt@figure {}\">",
                          use_id("figure", name), name, name, name),
              "", ""));
  for (Float& outer : floats_) {
    PageMark& mark = result_.marks[outer.mark - 1];
    mark.open =
        boost::replace_all_copy(mark.open, "@name@", fmt::format(" data-figure=\"{}\"", name));
  }
}

void Expander::picture(TexScanner& in, const TexToken&) {
  option(in);
  const std::string name(argument(in));
  if (!fs::is_regular_file(sources_.document / name)) {
    return fail(fmt::format("unknown picture '{}'", name));
  }
  result_.pictures.push_back(name);
  emit(marked(fmt::format("<img class=\"lit-drawing\" src=\"pictures/{}\" alt=\"@alt@picture {}\">",
                          escape_html(name), escape_html(name)),
              "", ""));
}

void Expander::excerpt(TexScanner& in, const TexToken&) {
  const auto said = option(in);
  const std::string name(argument(in));
  if (!names_.excerpts.contains(name)) return fail(fmt::format("unknown excerpt '{}'", name));
  const nlohmann::json& facts = registered_.at("excerpts").at(name);
  const std::string file = facts.at("file");
  const int first = facts.at("first_line"), last = facts.at("last_line");
  const PrintedNumber number = numbers_.take("lstlisting");
  begin_block(fmt::format("<figure class=\"lit-listing\" id=\"lst:{}\" data-listing=\"{}:{}-{}\">",
                          name, escape_html(file), first, last),
              "</figure>");
  begin_block("<figcaption>", "</figcaption>");
  emit(marked("<span class=\"lit-label\">", number.shown + "~" + number.number, "</span>: "));
  if (said) read_all(std::string(*said) + ". ");
  const std::string lines =
      first == last ? fmt::format("line~{}", first) : fmt::format("lines~{}--{}", first, last);
  emit(marked(fmt::format("<code>{}</code>", escape_html(file)), ", ", ""));
  std::string address;
  if (macros_.contains("LiterateSourceUrl")) {
    address =
        expanded(fmt::format("\\LiterateSourceUrl{{\\papercommit}}{{{}}}{{{}}}", file, first));
  }
  emit(address.empty() ? lines : fmt::format("\\href{{{}}}{{{}}}", address, lines));
  end_block();
  listing(sys::read_file(sources_.generated / "excerpts" / (name + ".txt")),
          facts.value("language", ""), first);
  end_block();
}

}  // namespace literate

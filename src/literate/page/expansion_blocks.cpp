// SPDX-License-Identifier: GPL-3.0-or-later
// What LaTeX numbers and cites, and the environments whose form a page has to know.
#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <regex>
#include <set>

#include "literate/page/expansion.hpp"
#include "literate/page/expansion_reading.hpp"
#include "literate/page/html_text.hpp"
#include "literate/text/characters.hpp"
#include "literate/text/latex.hpp"
#include "literate/text/unit.hpp"
#include "system/decimal.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/lines.hpp"

namespace literate {
namespace fs = std::filesystem;
using namespace page_reading;
namespace {

// A unit of siunitx with a solidus, as the PDF has it: \joule\per\mole\per\kelvin is J/(mol K).
std::string unit_with_solidus(std::string_view unit) {
  static const std::set<std::string_view, std::less<>> prefixes{
      "yocto", "zepto", "atto",  "femto", "pico",   "nano", "micro", "milli",
      "centi", "deci",  "deca",  "hecto", "kilo",   "mega", "giga",  "tera",
      "peta",  "exa",   "zetta", "yotta", "square", "cubic"};
  std::string above, below;
  std::string* part = &above;
  int n_below = 0;
  bool is_whole = true, is_below = false;  // whether a unit was read, and the next stands below
  TexScanner in(unit);
  while (const auto token = in.next()) {
    const bool is_power = token->name == "squared" || token->name == "cubed" ||
                          token->name == "tothe" || token->kind != TexKind::command;
    if (token->name == "per") {
      is_below = true;
      continue;
    }
    if (is_whole && !is_power) {
      part = is_below ? &below : &above;
      n_below += is_below ? 1 : 0;
      is_below = false;
      if (!part->empty()) *part += "\\,\\si{}";
    }
    if (part->empty()) *part = "\\si{}";
    part->insert(part->size() - 1, token->text);
    if (!is_power) is_whole = !prefixes.contains(token->name);
  }
  if (n_below == 0) return above;
  return above + (n_below > 1 ? "/(" + below + ")" : "/" + below);
}

std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_last = i + 1 == parts.size();
    text += (i == 0 ? "" : !is_last ? ", " : " and~") + parts[i];
  }
  return text;
}

}  // namespace

const std::map<std::string_view, Expander::Handler>& Expander::commands() {
  using E = Expander;
  static const std::map<std::string_view, Handler> all = [] {
    std::map<std::string_view, Handler> table;
    const auto add = [&](Handler handler, std::initializer_list<std::string_view> names) {
      for (const std::string_view name : names) table[name] = handler;
    };
    add(&E::define, {"newcommand", "renewcommand", "providecommand", "DeclareRobustCommand"});
    add(&E::define_by_pattern, {"def", "gdef"});
    add(&E::define_environment, {"newenvironment", "renewenvironment"});
    add(&E::define_theorem, {"newtheorem"});
    add(&E::define_operator, {"DeclareMathOperator"});
    add(&E::set_picture, {"LiteratePicture"});
    add(&E::document_class, {"documentclass"});
    add(&E::metadata, {"title", "author", "date"});
    add(&E::title_line, {"affiliation", "address", "email", "cortext"});
    add(&E::author_name, {"LiterateAuthor"});
    add(&E::package, {"usepackage", "RequirePackage"});
    add(&E::condition, {"ifdim", "ifnum", "iftrue", "iffalse"});
    add(&E::letter_region, {"makeatletter"});
    add(&E::value, {"val"});
    add(&E::raw_value, {"rawval"});
    add(&E::flag, {"ifflag"});
    add(&E::modified, {"ifpapermodified"});
    add(&E::repository, {"LiterateRepository"});
    add(&E::quoted, {"quoted", "quotedpage"});
    add(&E::statement, {"statement"});
    add(&E::claim, {"claim"});
    add(&E::verdict_sign, {"verdictsign"});
    add(&E::claim_count, {"claimcount"});
    add(&E::finding_says, {"findingsays"});
    add(&E::finding, {"finding"});
    add(&E::limit_kind, {"limitkind"});
    add(&E::limit, {"LedgerLimit"});
    add(&E::sentence, {"LedgerNumber", "LedgerSentence", "LedgerSource"});
    add(&E::ledger, {"claimledger"});
    add(&E::index, {"valueindex"});
    add(&E::provenance, {"provenance"});
    add(&E::provenance_file, {"LiterateFiles", "LiterateFile"});
    add(&E::table, {"tab"});
    add(&E::figure, {"fig"});
    add(&E::picture, {"includegraphics"});
    add(&E::excerpt, {"excerpt"});
    add(&E::title, {"maketitle"});
    add(&E::heading,
        {"part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph"});
    add(&E::appendix, {"appendix", "appendices"});
    add(&E::bookmark_setup, {"bookmarksetup"});
    add(&E::label, {"label"});
    add(&E::reference, {"ref", "eqref", "pageref", "nameref", "autoref"});
    add(&E::clever_reference, {"cref", "Cref", "labelcref"});
    add(&E::clever_range, {"crefrange", "Crefrange"});
    add(&E::citation, {"cite", "citep", "citet", "citealp", "onlinecite"});
    add(&E::bibliography, {"bibliography", "printindex"});
    add(&E::footnote, {"footnote", "footnotemark", "footnotetext", "thanks"});
    add(&E::caption, {"caption", "captionof"});
    add(&E::subfloat, {"subfloat"});
    add(&E::caption_setup, {"captionsetup"});
    add(&E::item, {"item"});
    add(&E::input, {"input", "include"});
    add(&E::number, {"num", "qty", "SI"});
    add(&E::ensure_math, {"ensuremath"});
    add(&E::unit, {"si", "unit"});
    add(&E::boxed, {"makebox", "framebox"});
    add(&E::rule, {"rule"});
    add(&E::step_counter, {"stepcounter", "refstepcounter"});
    add(&E::set_counter, {"setcounter", "addtocounter"});
    add(&E::remove_blanks, {"unskip"});
    add(&E::skip_length, {"hskip", "vskip", "kern", "penalty"});
    return table;
  }();
  return all;
}

const std::map<std::string_view, Expander::Handler>& Expander::environments() {
  using E = Expander;
  static const std::map<std::string_view, Handler> all = [] {
    std::map<std::string_view, Handler> table;
    const auto add = [&](Handler handler, std::initializer_list<std::string_view> names) {
      for (const std::string_view name : names) table[name] = handler;
    };
    add(&E::findings, {"findings"});
    add(&E::float_environment, {"figure", "figure*", "table", "table*", "wrapfigure", "subfigure",
                                "subtable", "sidewaystable", "sidewaysfigure"});
    add(&E::list, {"enumerate", "itemize", "description"});
    add(&E::abstract, {"abstract"});
    add(&E::proof, {"proof"});
    add(&E::transparent, {"document", "subequations", "multicols", "minipage", "flushleft",
                          "flushright", "titlepage", "appendices", "frontmatter", "acknowledgments",
                          "small", "footnotesize", "raggedright", "sloppypar"});
    add(&E::tabular, {"tabular", "tabular*", "tabularx", "longtable"});
    add(&E::bibliography_items, {"thebibliography"});
    add(&E::display,
        {"equation", "equation*", "align", "align*", "alignat", "alignat*", "flalign", "flalign*",
         "gather", "gather*", "multline", "multline*", "eqnarray", "eqnarray*", "displaymath"});
    return table;
  }();
  return all;
}

// \bookmarksetup{startatroot}: what follows is in no part.
void Expander::bookmark_setup(TexScanner& in, const TexToken&) {
  for (const std::string& setting : names_in(argument(in))) {
    if (setting == "startatroot") has_parts_ = false;
  }
}

void Expander::appendix(TexScanner&, const TexToken&) {
  is_appendix_ = true;
}

// What these classes print before the letter of an appendix.
std::string Expander::appendix_word(std::string_view heading) const {
  const bool has_word = class_ == "IEEEtran" || class_.starts_with("revtex");
  return is_appendix_ && has_word && heading == "section" ? "Appendix~" : "";
}

// Levels of headings follow each other, since assistive software reads them so: with parts or
// chapters a section is deeper than before the first of them.
void Expander::heading(TexScanner& in, const TexToken& token) {
  static const std::vector<std::string> names{
      "part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph"};
  const std::string name(token.name);
  const bool is_starred = token.text.ends_with('*');
  option(in);
  const std::string text = expanded(argument(in));
  std::string number, printed;
  if (!is_starred && numbers_.has(name)) {
    const PrintedNumber found = numbers_.take(name);
    number = found.number;
    const bool has_word = name == "part" || name == "chapter";
    printed = expanded(has_word              ? found.shown + "~" + number
                       : found.shown.empty() ? appendix_word(name) + number
                                             : appendix_word(name) + found.shown);
  }
  const auto level = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  if (level <= 2) section_ = expanded(number);
  if (level > 4) {
    return emit(fmt::format("\n\n{}\\textbf{{{}}} ", printed.empty() ? "" : printed + " ", text));
  }
  has_parts_ = has_parts_ || level == 0;
  has_chapters_ = has_chapters_ || level == 1;
  const std::size_t above = level == 0 ? 0 : (has_parts_ ? 1 : 0);
  const std::size_t depth = above + (level < 2 ? 0 : level - 2 + (has_chapters_ ? 1 : 0));
  const std::string mark =
      printed.empty() ? "" : marked("<span class=\"lit-number\">", printed, "</span>");
  emit(fmt::format("\n\n\\{}{{{} {}}}", names[depth + 2], mark, text));
  TexScanner behind(in.rest());
  skip_blanks(behind);
  if (behind.rest().starts_with("\\label{")) {
    in = behind;
    in.next();
    const std::string key(argument(in));
    if (!number.empty()) hold_against(key, number, "");
    ids_.insert(key);
    emit("\\label{" + key + "}");
  }
  emit("\n\n");
}

void Expander::label(TexScanner& in, const TexToken&) {
  const std::string key(argument(in));
  if (is_math_) return;
  const std::string id = fmt::format(" id=\"{}\"", escape_html(key));
  if (!floats_.empty()) {
    std::string& open = result_.marks[floats_.back().mark - 1].open;
    if (open.find("@id@") != std::string::npos) {
      open = boost::replace_all_copy(open, "@id@", id);
      return;
    }
  }
  emit(marked("<span" + id + ">", "", "</span>"));
}

std::string Expander::link_to(const std::string& key, const std::string& latex) {
  const std::string text = expanded(latex);
  if (is_math_) return text;
  return marked(fmt::format("<a class=\"lit-ref\" href=\"#{}\">", escape_html(key)), text, "</a>");
}

std::string Expander::number_of(const std::string& key) const {
  const PrintedLabel& label = numbers_.label(key);
  const bool is_equation = label.type == "equation" || label.type == "subequation";
  return is_equation ? "(" + label.number + ")" : label.number;
}

void Expander::reference(TexScanner& in, const TexToken& token) {
  const std::string key(argument(in));
  const PrintedLabel& label = numbers_.label(key);
  const std::string name(token.name);
  if (name == "ref") return emit(link_to(key, label.number));
  if (name == "pageref") return emit(link_to(key, label.page));
  if (name == "nameref") return emit(link_to(key, expanded(label.title)));
  if (name == "autoref") {
    return emit(link_to(key, expanded(numbers_.auto_name(label) + label.number)));
  }
  emit(link_to(key, label.number.starts_with('(') ? label.number : "(" + label.number + ")"));
}

// As cleveref does: sorted, of one kind after the other, three and more in a row as a range.
void Expander::clever_reference(TexScanner& in, const TexToken& token) {
  std::vector<std::pair<std::string, std::vector<std::string>>> kinds;
  for (const std::string& key : names_in(argument(in))) {
    const std::string& type = numbers_.label(key).type;
    auto kind =
        std::ranges::find(kinds, type, &std::pair<std::string, std::vector<std::string>>::first);
    if (kind == kinds.end()) kind = kinds.insert(kinds.end(), {type, {}});
    kind->second.push_back(key);
  }
  std::vector<std::string> texts;
  for (auto& [type, keys] : kinds) {
    std::ranges::sort(keys, {}, [&](const std::string& key) { return numbers_.label(key).order; });
    const auto names = numbers_.names(type);
    const bool is_capital = token.name == "Cref" && texts.empty();
    const std::size_t form = (is_capital ? 2U : 0U) + (keys.size() > 1 ? 1U : 0U);
    const std::string name = token.name == "labelcref" ? "" : names[form] + "~";
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < keys.size();) {
      std::size_t end = i + 1;
      while (end < keys.size() && numbers_.follows(keys[end - 1], keys[end])) ++end;
      if (end - i < 3) end = i + 1;
      const std::string begin = parts.empty() ? name : "";
      parts.push_back(link_to(keys[i], begin + number_of(keys[i])));
      if (end - i >= 3) parts.back() += " to~" + link_to(keys[end - 1], number_of(keys[end - 1]));
      i = end;
    }
    texts.push_back(listed(parts));
  }
  emit(listed(texts));
}

void Expander::clever_range(TexScanner& in, const TexToken& token) {
  const std::string first(argument(in)), last(argument(in));
  const auto names = numbers_.names(numbers_.label(first).type);
  emit(link_to(first, names[token.name == "Crefrange" ? 3 : 1] + "~" + number_of(first)) + " to~" +
       link_to(last, number_of(last)));
}

// The keys of a citation in the order of the PDF, and which of them only a range holds.
std::vector<std::pair<std::string, bool>> Expander::cited_in_order(
    std::vector<std::string> keys) const {
  const auto number = [&](const std::string& key) {
    return sys::parsed<int>(numbers_.citation(key)[0]);
  };
  const bool is_numbered =
      std::ranges::all_of(keys, [&](const std::string& key) { return number(key).has_value(); });
  if (is_numbered && sorts_citations_) std::ranges::stable_sort(keys, {}, number);
  std::vector<std::pair<std::string, bool>> cited;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool is_between = is_numbered && compresses_citations_ && i > 0 && i + 1 < keys.size() &&
                            *number(keys[i - 1]) + 1 == *number(keys[i]) &&
                            *number(keys[i]) + 1 == *number(keys[i + 1]);
    cited.emplace_back(keys[i], is_between);
  }
  return cited;
}

// natbib's citations of author and year stand in the text, or in brackets where they have a note.
void Expander::citation(TexScanner& in, const TexToken& token) {
  const auto first = option(in), second = option(in);
  const std::string before(second ? *first : ""), behind(second ? *second : first.value_or(""));
  const bool is_bare = token.name == "cite" && is_author_year_ && !first;
  const bool is_textual = token.name == "citet" || is_bare;
  const std::string open = has_round_citations_ ? "(" : "{[}";
  const std::string close = has_round_citations_ ? ")" : "{]}";
  const std::string between = is_author_year_                       ? "; "
                              : class_ == "IEEEtran" && !is_textual ? "{]}, {[}"
                                                                    : ", ";
  const std::string range = class_ == "IEEEtran" ? "{]}–{[}" : "–";
  std::string text;
  bool is_range = false;
  for (const auto& [key, is_between] : cited_in_order(names_in(argument(in)))) {
    if (is_between && !is_textual) {
      is_range = true;
      continue;
    }
    const std::vector<std::string> cited = numbers_.citation(key);
    const std::string& number = is_author_year_ ? cited.at(1) : cited[0];
    std::string shown = number;
    if (is_textual) shown = (cited.size() > 2 ? cited[2] + " " : "") + open + number + close;
    if (!is_textual && is_author_year_) shown = cited[2] + ", " + number;
    text += (text.empty()                     ? ""
             : std::exchange(is_range, false) ? range
                                              : between) +
            marked(fmt::format("<a class=\"lit-cite\" href=\"#bib-{}\">", escape_html(key)), shown,
                   "</a>");
  }
  if (!before.empty()) text = expanded(before) + " " + text;
  if (!behind.empty()) text += ", " + expanded(behind);
  emit(is_textual || token.name == "citealp" ? text : open + text + close);
}

// What BibTeX or MakeIndex wrote for the PDF.
void Expander::bibliography(TexScanner& in, const TexToken& token) {
  const bool is_index = token.name == "printindex";
  if (!is_index) argument(in);
  fs::path file = sources_.aux;
  read_all(sys::read_file(file.replace_extension(is_index ? ".ind" : ".bbl")));
}

void Expander::bibliography_items(TexScanner& in, const TexToken& token) {
  const std::string_view body = body_of(in, token.name);
  if (has_heads()) read_all("\\section*{\\refname}");
  begin_block("<ol class=\"lit-bibliography\">", "</ol>");
  const std::string counter = numbers_.has("enumiv") ? "enumiv" : "NAT@ctr";
  bool is_open = false;
  TexScanner items(body.substr(group_at(body).size()));
  while (const auto part = items.next()) {
    if (part->name != "bibitem") {
      if (is_open || part->name == "newcommand" || part->name == "providecommand")
        read(items, *part);
      continue;
    }
    // Its own label is none of the counter's.
    if (!option(items) && numbers_.has(counter)) numbers_.take(counter);
    const std::string key(argument(items));
    if (is_open) end_block();
    begin_block(fmt::format("<li id=\"bib-{}\">", escape_html(key)), "</li>");
    if (!is_author_year_) {
      emit(marked("<span class=\"lit-bib-label\">", "{[}" + numbers_.citation(key)[0] + "{]}",
                  "</span> "));
    }
    is_open = true;
  }
  if (is_open) end_block();
  end_block();
}

void Expander::footnote(TexScanner& in, const TexToken& token) {
  const auto given = option(in);
  std::size_t note_number = notes_.size();
  if (token.name == "footnotetext") {
    const auto mark = given ? std::find(notes_.rbegin(), notes_.rend(), *given) : notes_.rbegin();
    note_number = static_cast<std::size_t>(notes_.rend() - mark);
  } else {
    // REVTeX may print notes among the sources; IEEEtran's notes to the title have no mark.
    const bool is_title = token.name == "thanks";
    const bool has_number = numbers_.has("footnote") &&
                            (!is_title || numbers_.peek("footnote").number.starts_with('\\'));
    const std::string note = fmt::format("Note{}", n_notes_among_sources_ + 1);
    if (!is_title && numbers_.cites(note)) {
      ++n_notes_among_sources_;
      if (has_number) numbers_.take("footnote");
      argument(in);
      return read_all("\\cite{" + note + "}");
    }
    const std::string number = given        ? std::string(*given)
                               : has_number ? expanded(numbers_.take("footnote").number)
                                            : "";
    notes_.push_back(number);
    note_number = notes_.size();
    const std::string place = fmt::format("note-{}", note_number);
    emit(
        marked(fmt::format("<sup class=\"lit-note-mark\"><a id=\"{0}-mark\" href=\"#{0}\">", place),
               number, "</a></sup>"));
  }
  if (token.name == "footnotemark") return;
  const std::string text = expanded(argument(in));
  emit(marked(fmt::format("<span class=\"lit-note\" id=\"note-{}\" role=\"note\">", note_number),
              text, "</span>"));
}

void Expander::caption(TexScanner& in, const TexToken& token) {
  const bool is_starred = token.text.ends_with('*');
  std::string counter = floats_.empty() ? "figure" : floats_.back().counter;
  if (token.name == "captionof") counter = argument(in);
  option(in);
  const std::string_view text = argument(in);
  const bool is_first =
      !floats_.empty() && !floats_.back().has_caption && !counter.starts_with("sub");
  begin_block(is_first ? "<figcaption>" : "<div class=\"lit-caption\">",
              is_first ? "</figcaption>" : "</div>");
  if (!floats_.empty()) floats_.back().has_caption = true;
  if (!is_starred) {
    const PrintedNumber number = numbers_.take(counter);
    const std::string shown =
        counter.starts_with("sub") ? "(" + number.number + ")" : number.shown + "~" + number.number;
    emit(marked("<span class=\"lit-label\">", shown,
                counter.starts_with("sub") ? "</span> " : "</span>: "));
  }
  read_all(text);
  end_block();
}

// \\subfloat[caption]{content}
void Expander::subfloat(TexScanner& in, const TexToken&) {
  const std::string caption(option(in).value_or(""));
  const std::string content(argument(in));
  read_all(fmt::format("\\begin{{subfigure}}{{}}{}{}\\end{{subfigure}}", content,
                       caption.empty() ? "" : "\\caption{" + caption + "}"));
}

// type=figure within a table: this minipage has a figure's caption.
void Expander::caption_setup(TexScanner& in, const TexToken&) {
  option(in);
  for (const std::string& setting : names_in(argument(in))) {
    if (!setting.starts_with("type=") || floats_.empty()) continue;
    floats_.back().outer = std::exchange(floats_.back().counter, setting.substr(5));
  }
}

void Expander::item(TexScanner& in, const TexToken&) {
  const auto given = option(in);
  const bool is_described = !ends_.empty() && ends_.back().first == "description";
  if (given && is_described) return emit("\\item[" + expanded(*given) + "] ");
  emit("\\item ");
  if (lists_.empty()) return;
  auto& [counter, n] = lists_.back();
  if (counter.empty() && !given) return;
  const std::string shown = given ? std::string(*given) : numbers_.take(counter).shown;
  if (shown != std::to_string(++n) + ".") {
    emit(marked("<span class=\"lit-item\">", expanded(shown), "</span> "));
  }
}

void Expander::list(TexScanner& in, const TexToken& token) {
  option(in);
  const auto depth =
      std::ranges::count_if(lists_, [](const auto& list) { return !list.first.empty(); });
  const bool is_numbered = token.name == "enumerate";
  constexpr const char* counters[] = {"enumi", "enumii", "enumiii", "enumiv"};
  lists_.emplace_back(is_numbered ? counters[std::min<std::ptrdiff_t>(depth, 3)] : "", 0);
  ends_.emplace_back(token.name, "list");
  emit(fmt::format("\\begin{{{}}}", token.name));
}

void Expander::float_environment(TexScanner& in, const TexToken& token) {
  const std::string name(token.name);
  option(in);
  if (name == "wrapfigure" || name.starts_with("sub")) argument(in);
  if (name == "wrapfigure") argument(in);
  const bool is_table = name.find("table") != name.npos;
  const bool is_part = name.starts_with("sub");
  begin_block(is_part ? "<div class=\"lit-subfigure\"@id@>"
                      : fmt::format("<figure class=\"lit-{}\"@id@{}>",
                                    is_table ? "table-float" : "figure", is_table ? "" : "@name@"),
              is_part ? "</div>" : "</figure>");
  floats_.push_back({.counter = std::string(is_part ? "sub" : "") + (is_table ? "table" : "figure"),
                     .mark = result_.marks.size()});
  ends_.emplace_back(name, "float");
}

// What LaTeX sets as a picture, whose words are its source. Captions and labels are the page's own.
void Expander::picture_environment(TexScanner& in, const TexToken& token) {
  const std::string name(token.name);
  const std::string_view body = body_of(in, name);
  std::string drawn, texts;
  bool has_caption = false;
  const char* from = body.data();
  TexScanner parts(body);
  while (const auto part = parts.next()) {
    if (part->name != "caption" && part->name != "label") continue;
    drawn.append(from, part->text.data());
    if (part->name == "caption") option(parts);
    has_caption = has_caption || part->name == "caption";
    argument(parts);
    from = parts.rest().data();
    texts.append(part->text.data(), from);
  }
  drawn.append(from, body.data() + body.size());
  result_.typeset.push_back(fmt::format("{}{}\\end{{{}}}", token.text, drawn, name));
  const std::string image =
      fmt::format("<img class=\"lit-drawing\" src=\"figures/typeset-{}.svg\" alt=\"{}\">",
                  result_.typeset.size(), escape_html(result_.typeset.back()));
  begin_block(has_caption ? "<figure class=\"lit-figure\"@id@>" : "",
              has_caption ? "</figure>" : "");
  if (has_caption) {
    floats_.push_back({.counter = numbers_.captioned(name), .mark = result_.marks.size()});
  }
  fragment(image);
  read_all(texts);
  if (has_caption) floats_.pop_back();
  end_block();
}

void Expander::theorem(TexScanner& in, const TexToken& token) {
  const Theorem& kind = theorems_.find(token.name)->second;
  const auto note = option(in);
  std::string head = kind.name;
  if (kind.is_numbered) head += "~" + numbers_.take(kind.counter).number;
  begin_block("<div class=\"lit-theorem\">", "</div>", false);
  read_all(fmt::format("\\textbf{{{}}}{}. ", head, note ? " (" + std::string(*note) + ")" : ""));
  ends_.emplace_back(token.name, "block");
}

void Expander::proof(TexScanner& in, const TexToken& token) {
  const auto name = option(in);
  begin_block("<div class=\"lit-proof\">", "</div>", false);
  read_all(fmt::format("\\emph{{{}.}} ", name ? std::string(*name) : "Proof"));
  ends_.emplace_back(token.name, "~\\(\\square\\)\\end{lit-block}");
  ends_.insert(ends_.end() - 1, {"lit-block", "block"});
}

// An environment that is nothing but its content here, with the arguments that it takes.
void Expander::transparent(TexScanner& in, const TexToken& token) {
  while (option(in)) {
  }
  if (token.name == "multicols" || token.name == "minipage") argument(in);
  emit("\n\n");
  ends_.emplace_back(token.name, token.name == "minipage" ? "minipage" : "\n\n");
}

fs::path Expander::file_of(std::string_view name) const {
  fs::path file = sources_.document / std::string(name);
  if (!fs::is_regular_file(file)) file += ".tex";
  return file;
}

void Expander::input(TexScanner& in, const TexToken&) {
  const std::string name = expanded(argument(in));
  const fs::path file = file_of(name);
  if (!fs::is_regular_file(file)) return fail(fmt::format("'{}' is not there", name));
  read_file(file);
  emit("\n");
}

void Expander::boxed(TexScanner& in, const TexToken&) {
  static const std::regex length(R"(\s*[\d.]+(em|ex|pt|pc|mm|cm|in)\s*)");
  const std::string width(option(in).value_or(""));
  option(in);
  if (is_math_ || !std::regex_match(width, length)) {
    read_all(argument(in));
    return emit(width.empty() ? "" : " ");
  }
  const std::string text = expanded(argument(in));
  emit(marked(fmt::format("<span class=\"lit-box\" style=\"min-width:{}\">", width), text,
              "</span> "));
}

// \\hskip1em plus .5em minus .4em, \\penalty0
void Expander::skip_length(TexScanner& in, const TexToken& token) {
  static const std::regex length(
      R"(^\s*-?[\d.]+\s*[a-z]{2}(\s*plus\s*[\d.]+\s*[a-z]+)?(\s*minus\s*[\d.]+\s*[a-z]+)?)"),
      number(R"(^\s*-?\d+\s?)");
  std::match_results<std::string_view::const_iterator> found;
  const std::string_view rest = in.rest();
  const bool is_number = token.name == "penalty";
  if (std::regex_search(rest.begin(), rest.end(), found, is_number ? number : length)) {
    in.skip(static_cast<std::size_t>(found.length()));
  }
  emit(is_number ? "" : " ");
}

void Expander::step_counter(TexScanner& in, const TexToken&) {
  const std::string counter(argument(in));
  macros_["the" + counter] = {.body = numbers_.take(counter).number};
}

// Its number is known again when it is stepped.
void Expander::set_counter(TexScanner& in, const TexToken&) {
  macros_.erase("the" + std::string(argument(in)));
  argument(in);
}

void Expander::remove_blanks(TexScanner&, const TexToken&) {
  while (out_->ends_with(' ') || out_->ends_with('\n')) out_->pop_back();
}

// A bar, which may be drawn to scale.
void Expander::rule(TexScanner& in, const TexToken&) {
  option(in);
  const std::string width = expanded(argument(in)), height = expanded(argument(in));
  emit(marked(fmt::format("<span class=\"lit-rule\" style=\"width:{};height:{}\"></span>",
                          escape_html(width), escape_html(height)),
              "", ""));
}

void Expander::number(TexScanner& in, const TexToken& token) {
  option(in);
  std::string printed(sys::stripped(argument(in)));
  if (token.name == "num") return emit(quantity_latex(printed, is_math_));
  const std::string unit = unit_of_latex(argument(in));
  if (unit.find('\\') == unit.npos) {
    return unbroken(quantity_latex(printed + " " + unit, is_math_));
  }
  const std::string bare = unit_with_solidus(unit);
  unbroken(quantity_latex(printed, is_math_) +
           (bare.starts_with('/') ? ""
            : is_math_            ? "\\,"
                                  : "~") +
           bare);
}

void Expander::ensure_math(TexScanner& in, const TexToken&) {
  const std::string formula(argument(in));
  read_all(is_math_ ? formula : "$" + formula + "$");
}

// A number and its unit stand on one line.
void Expander::unbroken(const std::string& latex) {
  emit(is_math_ ? latex : marked("<span class=\"lit-nowrap\">", latex, "</span>"));
}

void Expander::unit(TexScanner& in, const TexToken&) {
  option(in);
  const std::string bare = unit_with_solidus(argument(in));
  emit(bare.starts_with('/') ? "1" + bare : bare);
}

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "literate/page/html_text.hpp"
#include "literate/page/page_writer.hpp"

namespace literate {
namespace {

using Kind = PageToken::Kind;

constexpr int max_depth = 4;  // marks within marks: a value in a heading in the contents

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    std::string part(text.substr(0, end));
    part.erase(0, std::min(part.find_first_not_of(" \n"), part.size()));
    while (part.ends_with(' ') || part.ends_with('\n')) part.pop_back();
    parts.push_back(std::move(part));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

bool is_whole_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

// «1, 2 and 5» of three pieces of HTML.
std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

std::string safe_id(std::string_view label) {
  std::string id;
  for (const char c : label) {
    id += c == ' ' || c == '\t' || c == '\n' || c == '"' || c == '<' || c == '>' || c == '&' ? '-'
                                                                                             : c;
  }
  return id;
}

}  // namespace

void PageWriter::reference(const PageToken& token) {
  reader_.star();
  const std::string key = reader_.text_argument();
  if (is_preamble_) return;
  PageToken place = token;
  place.body = key;
  char kind = 'r';
  if (token.text == "eqref") kind = 'q';
  if (token.text == "nameref") kind = 'n';
  html(mark(kind, key));
  wanted_labels_.emplace_back(place, key);
}

void PageWriter::clever_reference(const PageToken& token) {
  reader_.star();
  const std::string keys = reader_.text_argument();
  if (is_preamble_) return;
  const bool is_capital = token.text == "Cref" || package_options_.contains("capitalise") ||
                          package_options_.contains("capitalize");
  const std::string form = token.text == "labelcref" ? "n" : (is_capital ? "C" : "c");
  if (token.text == "crefrange" || token.text == "Crefrange") {
    const std::string last = reader_.text_argument();
    wanted_labels_.emplace_back(token, last);
    html(mark('c', form + "\n" + keys + "\n" + last));
  } else {
    html(mark('c', form + "\n" + keys));
  }
  for (const std::string& key : split(keys, ',')) wanted_labels_.emplace_back(token, key);
}

void PageWriter::reference_names(const PageToken& token) {
  const std::string type = reader_.text_argument();
  const std::string one = plain_text(reader_.argument());
  const std::string many = plain_text(reader_.argument());
  const auto capital = [](std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] -= 'a' - 'A';
    return text;
  };
  Names& names = reference_names_[type];
  if (token.text == "Crefname") {
    names.capital_one = one;
    names.capital_many = many;
    if (names.one.empty()) std::tie(names.one, names.many) = std::pair(one, many);
  } else {
    names = {one, many, capital(one), capital(many)};
  }
}

// How cleveref calls what a label names.
PageWriter::Names PageWriter::names_of(const std::string& type) const {
  const auto own = reference_names_.find(type);
  if (own != reference_names_.end()) return own->second;
  static const std::map<std::string, Names> abbreviated{
      {"equation", {"eq.", "eqs.", "Equation", "Equations"}},
      {"figure", {"fig.", "figs.", "Figure", "Figures"}}};
  static const std::map<std::string, Names> whole{
      {"equation", {"equation", "equations", "Equation", "Equations"}},
      {"figure", {"figure", "figures", "Figure", "Figures"}},
      {"table", {"table", "tables", "Table", "Tables"}},
      {"section", {"section", "sections", "Section", "Sections"}},
      {"subsection", {"section", "sections", "Section", "Sections"}},
      {"subsubsection", {"section", "sections", "Section", "Sections"}},
      {"paragraph", {"paragraph", "paragraphs", "Paragraph", "Paragraphs"}},
      {"part", {"part", "parts", "Part", "Parts"}},
      {"appendix", {"appendix", "appendices", "Appendix", "Appendices"}},
      {"item", {"item", "items", "Item", "Items"}},
      {"lstlisting", {"listing", "listings", "Listing", "Listings"}}};
  if (!package_options_.contains("noabbrev") && abbreviated.contains(type)) {
    return abbreviated.at(type);
  }
  return whole.contains(type) ? whole.at(type) : Names{type, type + "s", type, type + "s"};
}

void PageWriter::citation(const PageToken& token) {
  reader_.star();
  const auto first = reader_.optional_argument();
  const auto second = reader_.optional_argument();
  const std::string keys = reader_.text_argument();
  if (is_preamble_) return;
  const std::string before = first && second ? inline_html(*first) : "";
  const std::string after = second ? inline_html(*second) : (first ? inline_html(*first) : "");
  for (const std::string& key : split(keys, ',')) {
    cited_.push_back(key);
    wanted_citations_.emplace_back(token, key);
  }
  html(mark('t', keys + "\n" + before + "\n" + after));
}

void PageWriter::bibliography(const PageToken& token) {
  if (token.text == "bibliographystyle") {
    bibliography_style_ = reader_.text_argument();
    return;
  }
  bibliography_files_ = reader_.text_argument();
  if (is_preamble_) return;
  const int id = new_id("references");
  const std::string title = inline_html(page_tokens("\\refname"));
  headings_.push_back({1, "", title, id});
  last_level_ = 2;
  block("<h2 id=\"" + id_mark(id) + "\" class=\"lit-section\">" + title + "</h2>\n" +
        mark('b', ""));
}

// The environment thebibliography, by hand or as BibTeX writes it.
void PageWriter::bibliography_items(const std::string& name) {
  reader_.argument();
  const PageTokens body = reader_.environment_body(name);
  std::vector<PageToken> rest = reader_.set_aside();
  reader_.push(body);
  std::string items, key;
  PageTokens item;
  const auto finish = [&] {
    if (!key.empty()) {
      items += "<li id=\"bib-" + escape_html(key) + "\"><span class=\"lit-bib-label\">[" +
               bibliography_labels_[key] + "]</span> " + inline_html(item) + "</li>\n";
    }
    item.clear();
  };
  int n = 0;
  while (std::optional<PageToken> token = reader_.next()) {
    if (!token->is_command("bibitem")) {
      if (token->is(Kind::command) && reader_.read_definition(token->text)) continue;
      item.push_back(*std::move(token));
      continue;
    }
    finish();
    const auto own = reader_.optional_argument();
    key = reader_.text_argument();
    bibliography_labels_[key] = own ? inline_html(*own) : std::to_string(++n);
  }
  finish();
  reader_.take_back(std::move(rest));
  bibliography_html_ = "<ol class=\"lit-bibliography\">\n" + items + "</ol>\n";
}

// Has BibTeX make the bibliography of all that was cited, in the order of the text.
void PageWriter::finish_bibliography() {
  if (!bibliography_files_.empty() && sources_.bibliography) {
    std::string aux = "\\relax\n";
    for (const std::string& key : cited_) aux += "\\citation{" + key + "}\n";
    aux += "\\bibstyle{" + bibliography_style_ + "}\n\\bibdata{" + bibliography_files_ + "}\n";
    const std::string latex = cited_.empty() ? "" : sources_.bibliography(aux);
    is_preamble_ = false;
    const std::string before = std::exchange(out_, {});
    reader_.push(page_tokens(latex));
    run();
    out_ = before;
  }
  for (const auto& [token, key] : wanted_citations_) {
    if (!bibliography_labels_.contains(key))
      complain(token, "{" + key + "}: nothing is cited by this key");
  }
  for (const auto& [token, key] : wanted_labels_) {
    if (!labels_.contains(key)) complain(token, "{" + key + "}: there is no such \\label");
  }
}

void PageWriter::name_ids() {
  std::set<std::string> taken(printed_);
  taken.insert({"main", "contents", "lit-data"});
  for (std::size_t i = 0; i < id_fallbacks_.size(); ++i) {
    const std::string wanted = safe_id(id_labels_[i].empty() ? id_fallbacks_[i] : id_labels_[i]);
    std::string id = wanted;
    for (int n = 2; !taken.insert(id).second; ++n) id = wanted + "-" + std::to_string(n);
    ids_.push_back(std::move(id));
  }
}

const PageWriter::Target* PageWriter::find_label(const std::string& key) const {
  const auto found = labels_.find(key);
  return found == labels_.end() ? nullptr : &found->second;
}

std::string PageWriter::link(const Target& target, const std::string& shown) const {
  if (target.id < 0) return shown;
  return "<a class=\"lit-ref\" href=\"#" + ids_[static_cast<std::size_t>(target.id)] + "\">" +
         shown + "</a>";
}

// Replaces the marks that were made while what they say was not known.
std::string PageWriter::resolved(std::string_view html, int depth) const {
  std::string text;
  while (true) {
    const std::size_t begin = html.find('\x01');
    text += html.substr(0, begin);
    if (begin == std::string_view::npos) return text;
    std::size_t end = begin + 1;
    for (int open = 1; end < html.size(); ++end) {
      if (html[end] == '\x01') ++open;
      if (html[end] == '\x02' && --open == 0) break;
    }
    if (depth < max_depth) {
      text += resolved_mark(html[begin + 1], html.substr(begin + 2, end - begin - 2), depth + 1);
    }
    html.remove_prefix(std::min(end + 1, html.size()));
  }
}

std::string PageWriter::resolved_mark(char kind, std::string_view payload, int depth) const {
  const std::string text(payload);
  switch (kind) {
    case 'i':
      return ids_[static_cast<std::size_t>(std::atoi(text.c_str()))];
    case 'r':
    case 'q':
    case 'n': {
      const Target* const target = find_label(text);
      if (target == nullptr) return "??";
      const std::string shown = resolved(kind == 'n' ? target->title : target->number, depth);
      return link(*target, kind == 'q' ? "(" + shown + ")" : shown);
    }
    case 'c':
      return resolved(resolved_clever(text), depth);
    case 't':
      return resolved(resolved_citation(text), depth);
    case 'a':
      return text_of_html(
          resolved(later_texts_[static_cast<std::size_t>(std::atoi(text.c_str()))], depth));
    case 'b':
      return resolved(bibliography_html_, depth);
    case 'l':
      return printed_.contains(text) ? " href=\"#" + text + "\"" : "";
    case 'u': {
      const std::string uses = uses_text(text);
      return uses.empty() ? "" : ", " + resolved(uses, depth);
    }
    case 'v': {
      const std::size_t end = text.find('\n');
      const std::string shown = resolved(text.substr(end + 1), depth);
      const std::string id = "val-" + text.substr(0, end);
      if (!printed_.contains(id)) return shown;
      return "<a class=\"lit-quiet\" href=\"#" + id + "\">" + shown + "</a>";
    }
    default:
      return "";
  }
}

// \cref of one or several labels: in groups of a kind, sorted, three and more in a row as a range.
std::string PageWriter::resolved_clever(std::string_view payload) const {
  const std::vector<std::string> parts = split(payload, '\n');
  const bool is_range = parts.size() > 2;
  std::vector<const Target*> targets;
  for (const std::string& key : split(parts[1], ',')) targets.push_back(find_label(key));
  if (is_range) targets.push_back(find_label(parts[2]));
  if (std::ranges::find(targets, nullptr) != targets.end()) return "??";
  const auto family = [](const Target* target) {
    return target->type.ends_with("section") ? std::string("section") : target->type;
  };
  std::vector<std::string> families;
  for (const Target* target : targets) {
    if (std::ranges::find(families, family(target)) == families.end()) {
      families.push_back(family(target));
    }
  }
  std::vector<std::string> groups;
  for (const std::string& kind : families) {
    std::vector<const Target*> own;
    std::ranges::copy_if(targets, std::back_inserter(own),
                         [&](const Target* target) { return family(target) == kind; });
    const bool are_numbers = std::ranges::all_of(
        own, [](const Target* target) { return is_whole_number(target->number); });
    if (are_numbers) {
      std::ranges::stable_sort(own, {},
                               [](const Target* t) { return std::atoi(t->number.c_str()); });
    }
    const Names names = names_of(own.front()->type);
    std::string name = own.size() == 1 ? names.one : names.many;
    if (parts[0] == "C") name = own.size() == 1 ? names.capital_one : names.capital_many;
    name = parts[0] == "n" ? "" : name + "\u00A0";
    const auto shown = [&](const Target* target, const std::string& before) {
      const std::string number = kind == "equation" ? "(" + target->number + ")" : target->number;
      return link(*target, before + number);
    };
    std::vector<std::string> pieces;
    for (std::size_t i = 0; i < own.size();) {
      std::size_t last = i;
      while (are_numbers && last + 1 < own.size() &&
             std::atoi(own[last + 1]->number.c_str()) == std::atoi(own[last]->number.c_str()) + 1) {
        ++last;
      }
      const std::string before = i == 0 ? name : "";
      if (is_range || last - i >= 2) {
        if (is_range) last = own.size() - 1;
        pieces.push_back(shown(own[i], before) + " to " + shown(own[last], ""));
        i = last + 1;
      } else {
        pieces.push_back(shown(own[i], before));
        ++i;
      }
    }
    groups.push_back(listed(pieces));
  }
  return listed(groups);
}

std::string PageWriter::resolved_citation(std::string_view payload) const {
  const std::vector<std::string> parts = split(payload, '\n');
  std::vector<std::string> keys = split(parts[0], ',');
  std::string text;
  for (const std::string& key : keys) {
    const auto found = bibliography_labels_.find(key);
    if (!text.empty()) text += ", ";
    text += found == bibliography_labels_.end()
                ? "?"
                : "<a class=\"lit-cite\" href=\"#bib-" + escape_html(key) + "\">" + found->second +
                      "</a>";
  }
  const std::string before = parts[1].empty() ? "" : parts[1] + " ";
  const std::string after = parts[2].empty() ? "" : ", " + parts[2];
  return "<span class=\"lit-citation\">[" + before + text + after + "]</span>";
}

std::string PageWriter::head() {
  const auto found = metadata_.find("title");
  const auto plain = [&](const std::string& name) {
    const auto known = metadata_.find(name);
    return known == metadata_.end()
               ? ""
               : text_of_html(without_links(resolved(inline_html(known->second))));
  };
  const std::string title = found == metadata_.end() ? "Report" : plain("title");
  std::string description = text_of_html(resolved(description_));
  if (description.size() > 300) {
    description.resize(description.rfind(' ', 297));
    description += "…";
  }
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>" +
      title + "</title>\n";
  if (!description.empty()) html += "<meta name=\"description\" content=\"" + description + "\">\n";
  page_.title = title;
  page_.authors = plain("author");
  page_.date = plain("date");
  page_.description = description;
  return html + "<!--lit:meta-->\n<!--lit:style-->\n<!--lit:script-->\n</head>\n";
}

}  // namespace literate

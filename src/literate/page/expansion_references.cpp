// SPDX-License-Identifier: GPL-3.0-or-later
// What cites numbers and sources of the PDF, and the list of sources.
#include <fmt/core.h>

#include <algorithm>

#include "literate/page/expansion.hpp"
#include "literate/page/html_text.hpp"
#include "system/decimal.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
using namespace page_reading;

namespace {

std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_last = i + 1 == parts.size();
    text += (i == 0 ? "" : !is_last ? ", " : " and~") + parts[i];
  }
  return text;
}

}  // namespace

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

void Expander::know_references() {
  // \subref, whose number subcaption and subfig write under a name of its own.
  know({"subref"}, "m", [this](const Call& call) {
    std::string number = numbers_.label("sub@" + call[0]).number;
    if (call.is_starred) std::erase_if(number, [](char c) { return c == '(' || c == ')'; });
    emit(link_to(call[0], number));
  });
  know({"ref", "eqref", "pageref", "nameref", "autoref"}, "m", [this](const Call& call) {
    const PrintedLabel& label = numbers_.label(call[0]);
    std::string latex = label.number;
    if (call.name == "pageref") latex = label.page;
    if (call.name == "nameref") latex = label.title;
    if (call.name == "autoref") latex = numbers_.auto_name(label) + label.number;
    if (call.name == "eqref" && !latex.starts_with('(')) latex = "(" + latex + ")";
    emit(link_to(call[0], latex));
  });
  // As cleveref does: sorted, of one kind after the other, three and more in a row as a range.
  know({"cref", "Cref", "labelcref"}, "m", [this](const Call& call) {
    std::vector<std::pair<std::string, std::vector<std::string>>> kinds;
    for (const std::string& key : names_in(call.arguments[0])) {
      const std::string& type = numbers_.label(key).type;
      auto kind =
          std::ranges::find(kinds, type, &std::pair<std::string, std::vector<std::string>>::first);
      if (kind == kinds.end()) kind = kinds.insert(kinds.end(), {type, {}});
      kind->second.push_back(key);
    }
    std::vector<std::string> texts;
    for (auto& [type, keys] : kinds) {
      std::ranges::sort(keys, {},
                        [&](const std::string& key) { return numbers_.label(key).order; });
      const auto names = numbers_.names(type);
      const bool is_capital = call.name == "Cref" && texts.empty();
      const std::size_t form = (is_capital ? 2U : 0U) + (keys.size() > 1 ? 1U : 0U);
      const std::string name = call.name == "labelcref" ? "" : names[form] + "~";
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
  });
  know({"crefrange", "Crefrange"}, "mm", [this](const Call& call) {
    const auto names = numbers_.names(numbers_.label(call[0]).type);
    emit(link_to(call[0], names[call.name == "Crefrange" ? 3 : 1] + "~" + number_of(call[0])));
    emit(" to~" + link_to(call[1], number_of(call[1])));
  });
  // natbib's citations of author and year stand in the text, or in brackets where they have a note.
  know({"cite", "citep", "citet", "citealp", "onlinecite"}, "oom", [this](const Call& call) {
    const bool has_two = call.options[1].has_value();
    const std::string_view before = has_two ? call.option(0) : "", behind = call.option(has_two);
    const bool is_bare = call.name == "cite" && is_author_year_ && !call.options[0];
    const bool is_textual = call.name == "citet" || is_bare;
    const std::string open = expanded("\\PageCiteOpen"), close = expanded("\\PageCiteClose"),
                      between = expanded(is_textual && !is_author_year_ ? ", " : "\\PageCiteNext");
    std::string text;
    bool is_range = false;
    for (const auto& [key, is_between] : cited_in_order(names_in(call.arguments[0]))) {
      if (is_between && !is_textual) {
        is_range = true;
        continue;
      }
      const std::vector<std::string> cited = numbers_.citation(key);
      const std::string& number = is_author_year_ ? cited.at(1) : cited[0];
      std::string shown = number;
      if (is_textual) shown = (cited.size() > 2 ? cited[2] + " " : "") + open + number + close;
      if (!is_textual && is_author_year_) shown = cited[2] + ", " + number;
      if (!text.empty()) text += is_range ? expanded("\\PageCiteTo") : between;
      is_range = false;
      text += marked(fmt::format("<a class=\"lit-cite\" href=\"#bib-{}\">", escape_html(key)),
                     shown, "</a>");
    }
    if (!before.empty()) text = expanded(before) + " " + text;
    if (!behind.empty()) text += ", " + expanded(behind);
    emit(is_textual || call.name == "citealp" ? text : open + text + close);
  });
  // \PageBeside{bbl} is what BibTeX or MakeIndex wrote for the PDF.
  know({"PageBeside"}, "m", [this](const Call& call) {
    read_all(sys::read_file(fs::path(sources_.aux).replace_extension(call[0])));
  });
  know_environments({"thebibliography"}, "m", [this](const Call& call) {
    const std::string_view body = body_of(call.in, call.name);
    read_all("\\PageReferencesHead");
    begin_block("<ol class=\"lit-bibliography\">", "</ol>");
    const std::string counter = numbers_.next("enumiv") ? "enumiv" : "NAT@ctr";
    bool is_open = false;
    TexScanner items(body);
    while (const auto part = items.next()) {
      if (part->name != "bibitem") {
        if (is_open || part->name == "newcommand" || part->name == "providecommand")
          read(items, *part);
        continue;
      }
      // Its own label is none of the counter's.
      if (!option(items) && numbers_.next(counter)) numbers_.take(counter);
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
  });
}

}  // namespace literate

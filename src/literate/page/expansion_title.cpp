// SPDX-License-Identifier: GPL-3.0-or-later
// Title and authors, which each class for journals takes in its own way.
#include <fmt/core.h>

#include <algorithm>

#include "literate/page/expansion.hpp"
#include "literate/page/html_text.hpp"
#include "system/pattern.hpp"
#include "system/text.hpp"

namespace literate {
using namespace page_reading;
namespace {

// The names in an argument of \author, LaTeX. Lines below the names, marks and notes are none; a
// comma or «and» separates names unless the argument is one name.
std::vector<std::string> names_of(std::string text, bool is_one) {
  static const sys::Pattern comment(R"((^|[^\\])%[^\n]*\n\s*)"),
      group(R"([\s~]*\\and(?![A-Za-z])[\s~]*)"),
      block(R"(\\IEEEauthorblockN\s*\{((?:[^{}]|\{[^{}]*\})*)\})"),
      beside(R"(\\(?:corref|fnref|footnote|footnotemark|IEEEauthorrefmark|inst|IEEEauthorblockA|)"
             R"(IEEEmembership|textsuperscript|thanks)\s*(?:\[[^\]]*\])?\s*)"
             R"(\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}|\$[^$]*\$)"),
      separator(R"([\s~]*,(?![\s~]*(?:Jr\.?|Sr\.?|I{2,3}|IV|Ph\.?D\.?|M\.?D\.?)(?![A-Za-z]))[\s~]*)"
                R"((?:and[\s~])?|[\s~]+and[\s~]+)");
  constexpr std::string_view blanks = " \t\r\n~,";
  text = block.replaced_in(comment.replaced_in(text, "$1"), "$1");
  text = beside.replaced_in(text, "");
  std::vector<std::string> names;
  for (const std::string_view one : group.split(text)) {
    const std::string_view line = one.substr(0, one.find("\\\\"));
    for (const std::string_view name : is_one ? std::vector{line} : separator.split(line)) {
      const auto begin = std::min(name.find_first_not_of(blanks), name.size());
      const auto behind = name.find_last_not_of(blanks) + 1;
      if (begin < name.size()) names.emplace_back(name.substr(begin, behind - begin));
    }
  }
  return names;
}

// organization={Dept},city={X}: the values in their order, as elsarticle prints them.
std::string values_of_keys(const std::string& text) {
  static const sys::Pattern setting(R"(\w+\s*=\s*(?:\{((?:[^{}]|\{[^{}]*\})*)\}|([^,]*)))");
  std::string values;
  for (const sys::Pattern::Match& found : setting.all_in(text)) {
    const std::string value(sys::stripped(found.str(1) + found.str(2)));
    values += (values.empty() ? "" : ", ") + value;
  }
  return values.empty() ? text : values;
}

}  // namespace

// The authors and the lines below them. REVTeX prints lines that two authors share once.
std::string Expander::author_lines() const {
  std::vector<AuthorGroup> groups;
  for (const AuthorGroup& group : author_groups_) {
    if (is_revtex() && !groups.empty() && groups.back().lines == group.lines) {
      std::ranges::copy(group.authors, std::back_inserter(groups.back().authors));
    } else {
      groups.push_back(group);
    }
  }
  std::string latex;
  for (const auto& [authors, lines] : groups) {
    if (!latex.empty()) latex += "\\\\";
    for (std::size_t i = 0; i < authors.size(); ++i) {
      const bool ends = is_revtex() && i > 0 && i + 1 == authors.size();
      const char* const between = !ends ? ", " : i == 1 ? " and " : ", and ";
      latex += (i == 0 ? "" : between) + authors[i];
    }
    for (const std::string& line : lines) latex += "\\\\" + line;
  }
  return latex;
}

// The numbers of an author's addresses in elsarticle.
std::string Expander::title_marks(std::string_view labels) const {
  if (labels.empty() || class_ != "elsarticle") return {};
  std::string text;
  for (const std::string& label : names_in(labels)) {
    text += (text.empty() ? "" : ",") + numbers_.label(label).number;
  }
  return "\\textsuperscript{" + text + "}";
}

void Expander::know_title() {
  know_in_preamble({"author"}, "om", [this](const Call& call) {
    const std::string text = call[0];
    if (sys::stripped(text).empty()) return;
    const bool goes_on =
        !author_groups_.empty() && (author_groups_.back().lines.empty() || class_ == "elsarticle");
    if (!goes_on) author_groups_.emplace_back();
    author_groups_.back().authors.push_back(text + title_marks(call.option()));
    const bool is_one = call.options[0] || class_ == "elsarticle" || is_revtex();
    std::ranges::copy(names_of(text, is_one), std::back_inserter(authors_));
  });
  // What a class for journals says below an author.
  know_in_preamble({"affiliation", "address", "cortext"}, "om", [this](const Call& call) {
    if (author_groups_.empty()) author_groups_.emplace_back();
    const bool has_keys = call.name == "affiliation" && class_ == "elsarticle";
    author_groups_.back().lines.push_back(
        (call.name == "cortext" ? "\\textsuperscript{∗}" : title_marks(call.option())) +
        (has_keys ? values_of_keys(call[0]) : call[0]));
  });
  know_in_preamble({"email"}, "om", [this](const Call& call) {
    if (author_groups_.empty() || author_groups_.back().authors.empty()) return;
    author_groups_.back().authors.back() += "\\thanks{" + call[0] + "}";
  });
  know({"maketitle"}, "", [this](const Call&) {
    const std::string authors = author_lines();
    const auto date = macros_.find("the:date");
    std::string html = "<header class=\"lit-title\"><h1><tex>\\PageUse[]{the:title}</tex></h1>";
    if (!authors.empty()) html += "<p class=\"lit-authors\"><tex>" + authors + "</tex></p>";
    if (date != macros_.end() && !date->second.body.empty()) {
      html += "<p class=\"lit-date\"><tex>\\PageDate{" + date->second.body + "}</tex></p>";
    }
    for (const std::string& name : authors_) html += "<!--lit:author <tex>" + name + "</tex>-->";
    fragment(html + "<!--lit:cite-->\n</header>");
    macros_["maketitle"] = {};
  });
}

}  // namespace literate

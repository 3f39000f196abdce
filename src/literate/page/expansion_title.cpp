// SPDX-License-Identifier: GPL-3.0-or-later
// Title, authors and abstract, which each class for journals takes in its own way.
#include <fmt/core.h>

#include <algorithm>
#include <regex>
#include <set>

#include "literate/page/expansion.hpp"
#include "literate/page/expansion_reading.hpp"
#include "system/lines.hpp"

namespace literate {
using namespace page_reading;
namespace {

constexpr std::string_view blanks = " \t\r\n~";

// A text that may be a name, so marked, between its blanks.
std::string with_name(std::string_view text, bool may_be_name) {
  const auto begin = std::min(text.find_first_not_of(blanks), text.size());
  const auto end = text.find_last_not_of(blanks) + 1;
  if (!may_be_name || begin == text.size()) return std::string(text);
  return fmt::format("{}\\LiterateAuthor{{{}}}{}", text.substr(0, begin),
                     text.substr(begin, end - begin), text.substr(end));
}

// The argument of \author with each name in it as \LiterateAuthor{name}. Lines below the names,
// marks and notes are none; a comma or «and» separates names unless the argument is one name.
std::string with_names(std::string_view text, bool is_one) {
  static const std::set<std::string_view> marks{"corref",
                                                "fnref",
                                                "footnote",
                                                "footnotemark",
                                                "IEEEauthorrefmark",
                                                "inst",
                                                "IEEEauthorblockA",
                                                "IEEEmembership",
                                                "textsuperscript",
                                                "thanks"};
  static const std::regex separator(
      R"(,(?![\s~]*(?:Jr\.?|Sr\.?|I{2,3}|IV|Ph\.?D\.?|M\.?D\.?)(?![A-Za-z]))|[\s~]and[\s~])");
  std::string latex, name;
  bool is_name = true;
  const auto end_name = [&] { latex += with_name(std::exchange(name, ""), is_name); };
  TexScanner in(text);
  for (int depth = 0; const auto token = in.next();) {
    if (token->kind == TexKind::open) ++depth;
    if (token->kind == TexKind::close) --depth;
    if (depth > 0 || token->kind == TexKind::close) {
      name += token->text;
    } else if (token->kind == TexKind::comment) {
      skip_blanks(in);
    } else if (token->name == "IEEEauthorblockN") {
      end_name();
      is_name = true;
      latex += with_names(argument(in), is_one);
    } else if (token->name == "and") {
      end_name();
      skip_blanks(in);
      latex = sys::stripped(latex);
      latex += std::exchange(is_name, true) ? ", " : "\\\\";
    } else if (token->text == "\\\\") {
      end_name();
      latex += token->text;
      is_name = false;
    } else if (marks.contains(token->name)) {
      end_name();
      is_name = is_name && token->name != "IEEEauthorblockA";
      const char* const begin = token->text.data();
      option(in);
      argument(in);
      latex.append(begin, in.rest().data());
    } else if (token->kind == TexKind::dollar) {
      end_name();
      latex += token->text;
      for (auto part = in.next(); part; part = in.next()) {
        latex += part->text;
        if (part->kind == TexKind::dollar) break;
      }
    } else if (token->kind == TexKind::text && !is_one) {
      std::string rest(token->text);
      for (std::smatch found; std::regex_search(rest, found, separator); rest = found.suffix()) {
        name += found.prefix();
        end_name();
        latex += found.str();
      }
      name += rest;
    } else {
      name += token->text;
    }
  }
  end_name();
  return latex;
}

// organization={Dept},city={X}: the values in their order, as elsarticle prints them.
std::string values_of_keys(std::string_view text) {
  if (text.find('=') == text.npos) return std::string(text);
  std::string values;
  TexScanner in(text);
  for (auto equals = text.find('='); equals != text.npos; equals = in.rest().find('=')) {
    in.skip(equals + 1);
    skip_blanks(in);
    const std::string_view value =
        in.rest().starts_with('{') ? argument(in) : in.skip(in.rest().find(','));
    values += (values.empty() ? "" : ", ") + std::string(sys::stripped(value));
  }
  return values;
}

}  // namespace

void Expander::metadata(TexScanner& in, const TexToken& token) {
  const auto labels = option(in);
  const std::string text(argument(in));
  if (token.name != "author") {
    const bool is_dated = token.name == "date" && is_revtex() && !text.empty();
    metadata_[std::string(token.name)] = is_dated ? "(Dated: " + text + ")" : text;
    return;
  }
  if (sys::stripped(text).empty()) return;
  const bool goes_on =
      !author_groups_.empty() && (author_groups_.back().lines.empty() || class_ == "elsarticle");
  if (!goes_on) author_groups_.emplace_back();
  const bool is_one = labels || class_ == "elsarticle" || is_revtex();
  author_groups_.back().authors.push_back(with_names(text, is_one) +
                                          title_marks(labels.value_or("")));
}

// What a class for journals says below an author.
void Expander::title_line(TexScanner& in, const TexToken& token) {
  const std::string marks(option(in).value_or(""));
  const std::string text(argument(in));
  if (author_groups_.empty()) author_groups_.emplace_back();
  AuthorGroup& group = author_groups_.back();
  if (token.name == "email") {
    if (!group.authors.empty()) group.authors.back() += "\\thanks{" + text + "}";
  } else {
    group.lines.push_back(
        (token.name == "cortext" ? "\\textsuperscript{∗}" : title_marks(marks)) +
        (token.name == "affiliation" && class_ == "elsarticle" ? values_of_keys(text) : text));
  }
}

std::string Expander::title_marks(std::string_view labels) const {
  if (labels.empty() || class_ != "elsarticle") return {};
  std::string text;
  for (const std::string& label : names_in(labels)) {
    text += (text.empty() ? "" : ",") + numbers_.label(label).number;
  }
  return "\\textsuperscript{" + text + "}";
}

void Expander::author_name(TexScanner& in, const TexToken&) {
  emit(marked("<span class=\"lit-author\">", expanded(argument(in)), "</span>"));
}

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

void Expander::title(TexScanner&, const TexToken&) {
  if (std::exchange(has_title_, true)) return;
  std::string html = "<header class=\"lit-title\"><h1><tex>" + metadata_["title"] + "</tex></h1>";
  for (const auto& [kind, text] :
       {std::pair("authors", author_lines()), std::pair("date", metadata_["date"])}) {
    if (text.empty()) continue;
    html += fmt::format("<p class=\"lit-{}\"><tex>{}</tex></p>", kind, text);
  }
  fragment(html + "<!--lit:cite-->\n</header>");
}

// elsarticle has no \\maketitle, and REVTeX's stands behind the abstract.
void Expander::abstract(TexScanner& in, const TexToken& token) {
  if (class_ == "elsarticle" || is_revtex()) title(in, token);
  const char* head = has_heads() ? "><h2>Abstract</h2>" : " aria-label=\"Abstract\">";
  begin_block(std::string("<section class=\"lit-abstract\"") + head, "</section>", false);
  ends_.emplace_back(token.name, "block");
}

}  // namespace literate

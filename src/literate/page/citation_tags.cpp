// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/citation_tags.hpp"

#include <fmt/core.h>

#include <cctype>
#include <regex>

#include "literate/page/html_text.hpp"
#include "literate/text/characters.hpp"
#include "literate/text/latex.hpp"

namespace literate {
namespace {

// The first four digits in a row; empty if there are none.
std::string year_of(const std::string& date) {
  static const std::regex year(R"(\d{4})");
  std::smatch found;
  return std::regex_search(date, found, year) ? found.str() : "";
}

// 2026/11/22 of an ISO date, as Highwire's tags have it; the year of another text.
std::string publication_date(const std::string& date) {
  static const std::regex day(R"(^(\d{4})-(\d\d)-(\d\d))");
  std::smatch found;
  const bool is_iso = std::regex_search(date, found, day);
  return is_iso ? found.str(1) + "/" + found.str(2) + "/" + found.str(3) : year_of(date);
}

std::string key_word(const std::string& text) {
  std::string word;
  for (const char c : text) {
    if (is_letter(c)) word += static_cast<char>(std::tolower(c));
  }
  return word;
}

std::string address(const PageCitation& citation, const std::string& file) {
  return citation.site + (citation.site.ends_with('/') ? "" : "/") + file;
}

}  // namespace

std::string citation_tags(const PageCitation& citation) {
  std::string tags;
  const auto tag = [&](std::string_view attribute, std::string_view name,
                       const std::string& content) {
    if (content.empty()) return;
    tags += fmt::format("<meta {}=\"{}\" content=\"{}\">\n", attribute, name, escape_html(content));
  };
  tag("name", "citation_title", citation.title);
  for (const std::string& author : citation.authors) tag("name", "citation_author", author);
  tag("name", "citation_publication_date", publication_date(citation.date));
  tag("name", "citation_doi", citation.doi);
  if (!citation.site.empty()) tag("name", "citation_pdf_url", address(citation, citation.pdf));
  tag("property", "og:type", "article");
  tag("property", "og:title", citation.title);
  tag("property", "og:description", citation.description);
  if (!citation.site.empty()) {
    tag("property", "og:url", address(citation, ""));
    tag("property", "og:image", address(citation, "picture.png"));
    tag("name", "twitter:card", "summary_large_image");
  }
  return tags;
}

std::string bibtex_entry(const PageCitation& citation) {
  const std::string year = year_of(citation.date);
  std::string authors;
  for (const std::string& author : citation.authors) {
    // A group that goes by one name is no given and family name.
    const bool is_group = author.starts_with("The ");
    authors += (authors.empty() ? "" : " and ") +
               (is_group ? "{" + escape_latex(author) + "}" : escape_latex(author));
  }
  std::string family = citation.authors.empty() ? "anonymous" : citation.authors.front();
  family = key_word(family.substr(family.rfind(' ') + 1));
  const std::string first_word = key_word(citation.title.substr(0, citation.title.find(' ')));
  std::string entry = "@misc{" + family + year + first_word + ",\n  title = {{" +
                      escape_latex(citation.title) + "}}";
  if (!authors.empty()) entry += ",\n  author = {" + authors + "}";
  if (!year.empty()) entry += ",\n  year = {" + year + "}";
  if (!citation.doi.empty()) entry += ",\n  doi = {" + citation.doi + "}";
  if (!citation.site.empty()) entry += ",\n  url = {" + citation.site + "}";
  return entry + "\n}\n";
}

}  // namespace literate

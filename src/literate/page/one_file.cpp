// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/one_file.hpp"

#include <openssl/evp.h>

#include <fmt/core.h>
#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <vector>

#include "literate/page/html_text.hpp"
#include "literate/text/characters.hpp"
#include "literate/text/latex.hpp"
#include "system/files.hpp"
#include "system/pattern.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

std::string_view type_of(const fs::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".svg") return "image/svg+xml";
  if (ending == ".png") return "image/png";
  if (ending == ".jpg" || ending == ".jpeg") return "image/jpeg";
  return "font/woff2";
}

// Puts the bytes of each file into the text that names it behind `before`, up to `after`.
std::string with_files(const std::string& text, std::string_view before, char after,
                       const fs::path& folder) {
  std::string whole;
  std::size_t from = 0;
  for (auto at = text.find(before); at != text.npos; at = text.find(before, from)) {
    at += before.size();
    const auto end = text.find(after, at);
    const std::string name = text.substr(at, end - at);
    // A picture of PDF was made one of SVG.
    fs::path file = folder / name;
    if (file.extension() == ".pdf") file.replace_extension(".svg");
    whole += text.substr(from, at - from);
    whole += name.starts_with("data:") || name.starts_with("#") ? name
             : file.extension() == ".svg"                       ? svg_address(sys::read_file(file))
                                          : data_address(type_of(file), sys::read_file(file));
    from = end;
  }
  return whole + text.substr(from);
}

// The texts of all files in a folder with this ending, in the order of their names.
std::string joined_files(const fs::path& folder, std::string_view ending) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::string text;
  for (const fs::path& file : files) text += sys::read_file(file);
  return text;
}

// Links to files beside the page, the PDF by its kind and the others by their names.
std::string links_to(const std::vector<std::string>& files) {
  if (files.empty()) return {};
  std::string html = "<p class=\"lit-formats\">";
  for (const std::string& file : files) {
    const bool is_paper = &file == &files.front() && file.ends_with(".pdf");
    html += (&file == &files.front() ? "" : " · ") + std::string("<a href=\"") + escape_html(file) +
            "\">" + (is_paper ? "PDF" : escape_html(fs::path(file).filename().string())) + "</a>";
  }
  return html + "</p>\n";
}

}  // namespace

std::string svg_address(std::string_view svg) {
  std::string address = "data:image/svg+xml,";
  address.reserve(svg.size() + svg.size() / 8);
  for (const char& c : svg) {
    address += c == '"'    ? "'"
               : c == '#'  ? "%23"
               : c == '%'  ? "%25"
               : c == '&'  ? "%26"
               : c == '\n' ? " "
                           : std::string_view(&c, 1);
  }
  return address;
}

std::string data_address(std::string_view type, std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1,
                   '\0');  // with the zero that OpenSSL ends it by
  const std::string input(bytes);
  const int n = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                reinterpret_cast<const unsigned char*>(input.data()),
                                static_cast<int>(input.size()));
  text.resize(static_cast<std::size_t>(n));
  return "data:" + std::string(type) + ";base64," + text;
}

std::string one_file(std::string html, const PageParts& parts) {
  html = with_files(html, " src=\"", '"', parts.build);
  const std::string script = joined_files(parts.look, ".js");
  const std::string cite = parts.bibtex.empty()
                               ? ""
                               : "<details class=\"lit-cite-page\">\n<summary>Cite</summary>\n<pre "
                                 "tabindex=\"0\"><code>" +
                                     escape_html(parts.bibtex) + "</code></pre>\n</details>\n";
  const auto put = [&](const char* place, const std::string& element) {
    boost::replace_first(html, place, element);
  };
  put("<!--lit:style-->",
      "<style>\n" + with_files(joined_files(parts.look, ".css"), "url(\"", '"', parts.build) +
          "</style>");
  put("<!--lit:script-->\n", script.empty() ? "" : "<script>\n" + script + "</script>\n");
  put("<!--lit:meta-->\n", parts.meta);
  put("<!--lit:cite-->\n", links_to(parts.beside) + cite);
  put("<!--lit:data-->\n",
      parts.data.empty()
          ? ""
          : "<script type=\"application/json\" id=\"lit-data\">" + parts.data + "</script>\n");
  return html;
}

namespace {

// 2026/11/22 of an ISO date, as Highwire's tags have it; the year of another text.
std::string publication_date(const std::string& date) {
  static const sys::Pattern year_or_day(R"(\d{4}(-\d\d-\d\d)?)");
  const auto found = year_or_day.find_in(date);
  return found ? boost::replace_all_copy(found->str(), "-", "/") : "";
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
  const std::string year = publication_date(citation.date).substr(0, 4);
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

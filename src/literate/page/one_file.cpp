// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/one_file.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <vector>

#include "literate/page/html_text.hpp"
#include "system/files.hpp"

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

// Replaces «before NAME after» by «before address-of-NAME after», for every name in the text.
std::string with_files(std::string text, std::string_view before, std::string_view after,
                       const fs::path& folder) {
  std::string whole;
  std::string_view rest = text;
  while (true) {
    const std::size_t begin = rest.find(before);
    if (begin == std::string_view::npos) return whole + std::string(rest);
    const std::size_t name_begin = begin + before.size();
    const std::size_t end = rest.find(after, name_begin);
    const std::string name(rest.substr(name_begin, end - name_begin));
    whole += rest.substr(0, name_begin);
    // A picture of PDF was made one of SVG.
    fs::path file = folder / name;
    if (file.extension() == ".pdf") file.replace_extension(".svg");
    const bool is_address = name.starts_with("data:") || name.starts_with("#");
    if (is_address) {
      whole += name;
    } else if (file.extension() == ".svg") {
      whole += svg_address(sys::read_file(file));
    } else {
      whole += data_address(type_of(file), sys::read_file(file));
    }
    rest.remove_prefix(end);
  }
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

std::string in_place(const std::string& html, std::string_view placeholder,
                     const std::string& element) {
  const std::size_t at = html.find(placeholder);
  if (at == std::string::npos) return html;
  return html.substr(0, at) + element + html.substr(at + placeholder.size());
}

}  // namespace

std::string svg_address(std::string_view svg) {
  std::string address = "data:image/svg+xml,";
  address.reserve(svg.size() + svg.size() / 8);
  for (const char c : svg) {
    switch (c) {
      case '"':
        address += '\'';
        break;
      case '#':
        address += "%23";
        break;
      case '%':
        address += "%25";
        break;
      case '&':
        address += "%26";
        break;
      case '\n':
        address += ' ';
        break;
      default:
        address += c;
    }
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
  html = with_files(std::move(html), " src=\"", "\"", parts.build);
  const std::string style =
      with_files(joined_files(parts.look, ".css"), "url(\"", "\")", parts.build);
  const std::string script = joined_files(parts.look, ".js");
  html = in_place(html, "<!--lit:style-->", "<style>\n" + style + "</style>");
  html = in_place(html, "<!--lit:script-->\n",
                  script.empty() ? "" : "<script>\n" + script + "</script>\n");
  html = in_place(html, "<!--lit:meta-->\n", parts.meta);
  html = in_place(html, "<!--lit:cite-->\n",
                  links_to(parts.beside) +
                      (parts.bibtex.empty()
                           ? ""
                           : "<details class=\"lit-cite-page\">\n<summary>Cite</summary>\n<pre "
                             "tabindex=\"0\"><code>" +
                                 escape_html(parts.bibtex) + "</code></pre>\n</details>\n"));
  return in_place(html, "<!--lit:data-->\n",
                  parts.data.empty() ? ""
                                     : "<script type=\"application/json\" id=\"lit-data\">" +
                                           parts.data + "</script>\n");
}

}  // namespace literate

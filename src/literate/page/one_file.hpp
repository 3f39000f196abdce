// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace literate {

/// What goes into a page, so that it loads nothing.
struct PageParts {
  std::filesystem::path
      look;  ///< has style sheets, *.css, and scripts, *.js, joined in the order of names
  std::string data = {};    ///< JSON of the names in the page, without any '<'; may be empty
  std::string meta = {};    ///< elements for the page's head; may be empty
  std::string bibtex = {};  ///< an entry by which the page is cited; may be empty
  std::vector<std::string> beside = {};  ///< files beside the page, which its head then links
  std::filesystem::path
      build;  ///< has the figures as figures/NAME.svg, pictures/FILE, and the fonts
};

/// Puts style, script, data, figures, pictures and fonts into a page. Throws sys::OutputError
/// naming a file that is missing. A style sheet names fonts as url("x.woff2").
std::string one_file(std::string html, const PageParts& parts);

/// An SVG as an address: readable, which is shorter than base64, and without line ends.
std::string svg_address(std::string_view svg);

/// «data:type;base64,…» of a file's bytes.
std::string data_address(std::string_view type, std::string_view bytes);

/// How a page is cited.
struct PageCitation {
  std::string title;
  std::vector<std::string> authors;  ///< as they are printed, given name before family name
  std::string date;                  ///< ISO 8601, or a text with a year in it; may be empty
  std::string description;
  std::string doi = {};  ///< may be empty
  std::string site =
      {};                ///< where the page stands, such as https://example.org/paper; may be empty
  std::string pdf = {};  ///< the PDF's name beside the page, on a site
};

/// Elements for the page's head: Highwire tags, by which Zotero and Google Scholar know a work, and
/// Open Graph tags, by which networks show it. What needs a whole address, PDF and picture, is left
/// out without a site.
std::string citation_tags(const PageCitation& citation);

/// An entry for BibTeX; its key is the first author's last name, the year and the title's first
/// word.
std::string bibtex_entry(const PageCitation& citation);

}  // namespace literate

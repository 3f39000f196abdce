// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace literate {

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

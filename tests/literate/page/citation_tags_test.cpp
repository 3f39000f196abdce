// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/citation_tags.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(citation_tags_test)

using namespace literate;

namespace {

const PageCitation pendulum{.title = "Wide swings & more",
                            .authors = {"Ada Byron", "The Clock Makers"},
                            .date = "2026-11-22T15:27:11Z",
                            .description = "How long."};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(title_authors_and_day_are_told) {
  const std::string tags = citation_tags(pendulum);

  BOOST_TEST(contains(tags, "<meta name=\"citation_title\" content=\"Wide swings &amp; more\">"));
  BOOST_TEST(contains(tags, "<meta name=\"citation_author\" content=\"Ada Byron\">"));
  BOOST_TEST(contains(tags, "<meta name=\"citation_author\" content=\"The Clock Makers\">"));
  BOOST_TEST(contains(tags, "<meta name=\"citation_publication_date\" content=\"2026/11/22\">"));
}

BOOST_AUTO_TEST_CASE(addresses_are_told_on_a_site_alone) {
  PageCitation citation = pendulum;
  citation.site = "https://example.org/p";
  citation.pdf = "p.pdf";

  BOOST_TEST(!contains(citation_tags(pendulum), "http"));
  BOOST_TEST(contains(citation_tags(citation),
                      "\"citation_pdf_url\" content=\"https://example.org/p/p.pdf\""));
  BOOST_TEST(contains(citation_tags(citation),
                      "\"og:image\" content=\"https://example.org/p/picture.png\""));
}

BOOST_AUTO_TEST_CASE(an_entry_for_bibtex_has_a_key_of_name_year_and_word) {
  BOOST_TEST(
      bibtex_entry(pendulum) ==
      "@misc{byron2026wide,\n  title = {{Wide swings \\& more}},\n  author = {Ada Byron and {The "
      "Clock Makers}},\n  year = {2026}\n}\n");
}

BOOST_AUTO_TEST_CASE(a_date_without_a_year_is_none) {
  PageCitation citation = pendulum;
  citation.date = "today";

  BOOST_TEST(!contains(citation_tags(citation), "citation_publication_date"));
  BOOST_TEST(!contains(bibtex_entry(citation), "year"));
}

BOOST_AUTO_TEST_SUITE_END()

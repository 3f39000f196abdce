// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/one_file.hpp"

#include <boost/test/unit_test.hpp>

#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(one_file_test)

using namespace literate;

namespace {

const std::string page =
    "<head><!--lit:style-->\n<!--lit:script-->\n</head><img "
    "src=\"figures/a.svg\"><!--lit:data-->\n";

}  // namespace

BOOST_AUTO_TEST_CASE(bytes_are_written_in_base64) {
  BOOST_TEST(data_address("x/y", "Man") == "data:x/y;base64,TWFu");
  BOOST_TEST(data_address("x/y", "Ma") == "data:x/y;base64,TWE=");
  BOOST_TEST(data_address("x/y", "M") == "data:x/y;base64,TQ==");
}

BOOST_AUTO_TEST_CASE(style_script_data_figures_and_fonts_are_put_in) {
  const TemporaryFolder folder;
  folder.write("look/b.css", "b{}\n");
  folder.write("look/a.css", "a{src:url(\"f.woff2\")}\n");
  folder.write("look/a.js", "run();\n");
  folder.write("build/figures/a.svg", "<svg/>");
  folder.write("build/f.woff2", "M");

  const std::string html =
      one_file(page, {.look = folder / "look", .data = "{}", .build = folder / "build"});

  BOOST_TEST(html ==
             "<head><style>\na{src:url(\"data:font/woff2;base64,TQ==\")}\nb{}\n</"
             "style>\n<script>\nrun();\n"
             "</script>\n</head><img src=\"data:image/svg+xml,<svg/>\"><script "
             "type=\"application/json\" id=\"lit-data\">{}</script>\n");
}

BOOST_AUTO_TEST_CASE(a_drawing_has_no_character_that_an_address_may_not_have) {
  BOOST_TEST(svg_address("<a x=\"1\"\nid=\"#b\">50%</a>") ==
             "data:image/svg+xml,<a x='1' id='%23b'>50%25</a>");
}

BOOST_AUTO_TEST_CASE(a_picture_that_is_missing_is_told) {
  const TemporaryFolder folder;
  folder.write("look/a.css", "");

  BOOST_CHECK_THROW(one_file(page, {.look = folder / "look", .build = folder / "build"}),
                    sys::OutputError);
}

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/quotations.hpp"

#include <boost/test/unit_test.hpp>

#include "holds.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(quotations_test)

using namespace literate;
using boost::test_tools::per_element;

namespace {

const std::string two =
    "[steel]\npage = 8\nwords = \"steel is 5 % dearer\"\n\n[copper]\npage = \"iv\"\nwords = "
    "\"non-ferrous metals\"\n";

struct Place {
  explicit Place(const std::string& toml) { folder.write("report/quotations.toml", toml); }
  std::vector<Quotation> read() const { return read_quotations(folder.path() / "report"); }
  std::vector<std::string> errors(const std::string& text) const {
    return quotation_errors(read(), folder.write("text.txt", text));
  }
  std::string message() const {
    return message_of<sys::InputError>([&] { read(); });
  }

  TemporaryFolder folder;
};

}  // namespace

BOOST_AUTO_TEST_CASE(quotations_are_read_in_the_order_of_the_file_and_written_for_latex) {
  const auto quotations = Place(two).read();

  BOOST_TEST_REQUIRE(quotations.size() == 2U);
  BOOST_TEST(quotations[0].id == "steel");
  BOOST_TEST(quotations[1].page == "iv");
  BOOST_TEST(quotations_tex(quotations) ==
             "\\LiterateQuotation{steel}{8}{steel is 5 \\% dearer}\n"
             "\\LiterateQuotation{copper}{iv}{non-ferrous metals}\n");
  const TemporaryFolder empty;
  BOOST_TEST(read_quotations(empty.path()).empty());
}

BOOST_AUTO_TEST_CASE(white_space_and_hyphens_at_the_ends_of_lines_do_not_count) {
  const std::vector<std::string> none;
  BOOST_TEST(Place(two).errors("Now steel is\n  5 % dea-\nrer than non-\nferrous metals.") == none,
             per_element());
  BOOST_TEST(Place(two).errors("steel is 5%dearer nonfer-rous") != none);
}

BOOST_AUTO_TEST_CASE(blanks_within_words_and_between_them_count) {
  const auto n_errors = [](const std::string& words, const std::string& text) {
    return Place("[a]\npage = 1\nwords = \"" + words + "\"\n").errors(text).size();
  };
  BOOST_TEST(n_errors("a nail", "an ail") == 1U);
  BOOST_TEST(n_errors("no where", "nowhere") == 1U);
  BOOST_TEST(n_errors("nowhere", "no where") == 1U);
  BOOST_TEST(n_errors("nowhere", "no\nwhere") == 1U);
  BOOST_TEST(n_errors("no where", "no-\nwhere") == 1U);
  BOOST_TEST(n_errors("here and/or there", "here \t and/\nor\n\n there") == 0U);
  BOOST_TEST(n_errors("a - b", "a -\nb") == 0U);
}

BOOST_AUTO_TEST_CASE(straight_marks_of_quotation_open_and_close) {
  const auto words = [](const std::string& text) {
    return words_latex({.id = "a", .page = "1", .words = text, .place = ""});
  };

  BOOST_TEST(words("\"Near\" is (\"far\"), it's 5") ==
             "\\textquotedblleft{}Near\\textquotedblright{} is "
             "(\\textquotedblleft{}far\\textquotedblright{}), it's 5");
}

BOOST_AUTO_TEST_CASE(a_quotation_that_differs_is_told_with_both_places_and_what_follows) {
  const std::vector<std::string> expected = {
      "report/quotations.toml:3:9: quotation 'steel' differs after 'steel is': it goes on "
      "'5 % dearer', line 2 of the text 'cheaper. Copper and other'",
      "report/quotations.toml:7:9: quotation 'copper' differs after 'non-ferrous': it goes on "
      "'metals', line 3 of the text 'metal'"};

  BOOST_TEST(
      Place(two).errors("Yes,\nsteel is cheaper. Copper\nand other non-ferrous metal") == expected,
      per_element());
}

BOOST_AUTO_TEST_CASE(what_is_no_quotation_is_an_error_with_its_place) {
  for (const auto& [toml, part] : std::vector<std::pair<std::string, std::string>>{
           {"[steel]\npage = 8\n", "report/quotations.toml:1:2: quotation 'steel' has no words"},
           {"[steel]\nwords = \"x\"\n",
            "report/quotations.toml:2:9: quotation 'steel' has no page"},
           {"[steel]\nword = \"x\"\n", "report/quotations.toml:2:8: 'word' of quotation 'steel'"},
           {"[steel]\npage = 8.5\n", "report/quotations.toml:2:8: 'page' of quotation 'steel'"},
           {"steel = 8\n", "report/quotations.toml:1:1: 'steel' is not a table"},
           {"[steel\n", "report/quotations.toml:1:"},
           {"[\"a b\"]\n", "'a b' is no key"}}) {
    const std::string message = Place(toml).message();
    BOOST_TEST(holds(message, part));
  }
}

BOOST_AUTO_TEST_SUITE_END()

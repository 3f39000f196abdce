// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/page_html.hpp"

#include <boost/test/unit_test.hpp>

#include "holds.hpp"
#include "literate/document/document.hpp"

BOOST_AUTO_TEST_SUITE(page_html_test)

using namespace literate;

namespace {

Claim claim_of_apples(double limit) {
  return {.route = "weighing & adding up",
          .expected = Verdict::confirmed,
          .criteria = {Criterion::at_most("price", Value({2.612, 0.001}, fixed(2), "{kr}"),
                                          {LimitKind::data, limit, "half of the last digit"})}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_ledgers_entry_has_the_verdict_that_was_found) {
  Registered registered;
  registered.claims.emplace_back("apples", claim_of_apples(2.5));
  registered.places[{"claim", "apples"}] = {"src/apples.cpp", "register_apples", 12, 3};
  const LimitNotes notes(registered);
  const std::string html = claim_html(registered, notes, "apples", claim_of_apples(2.5));

  for (const char* part :
       {"id=\"claim-apples\"",
        "data-verdict=\"refuted\"><tex>\\verdictsign{refuted}</tex> refuted</strong>",
        "<strong>not confirmed as expected</strong>", "\\LedgerSentence{apples}",
        "weighing \\& adding up", "<strong><tex>\\qty{2.61}{kr}</tex></strong>",
        "$\\le$~\\qty{2.5}{kr}", "data-outcome=\"fails\"", "href=\"#limit-a\">[a]</a>",
        "1.0 times; 112 errors", "faults not known", "src/apples.cpp:12"}) {
    BOOST_TEST(holds(html, part));
  }
  BOOST_TEST(holds(limits_html(notes), "<li id=\"limit-a\"><strong>[a]</strong> <em>data:</em>"));
  BOOST_TEST(holds(limits_html(notes), "half of the last digit"));
}

BOOST_AUTO_TEST_CASE(limits_have_their_letters_and_notes_in_the_order_of_reading) {
  Registered registered;
  for (const char* id : {"apples", "pears"}) {
    Claim claim = claim_of_apples(2.5);
    claim.criteria = {Criterion::at_most("price", Value({2.612, 0.001}, fixed(2), "{kr}"),
                                         {LimitKind::data, 2.65, std::string("that of ") + id})};
    registered.claims.emplace_back(id, claim);
    registered.places[{"claim", id}] = {"src/fruit.cpp", "register_fruit", 12, 3};
  }
  const LimitNotes notes(registered);
  const auto html_of = [&](std::size_t i) {
    return claim_html(registered, notes, registered.claims[i].first, registered.claims[i].second);
  };

  std::vector<std::string> order;
  const std::string pears = lettered(html_of(1), order);
  const std::string apples = lettered(html_of(0), order);
  const std::string reasons = in_order(limits_html(notes), order);

  BOOST_TEST(holds(pears, "href=\"#limit-b\">[a]</a>"));
  BOOST_TEST(holds(apples, "href=\"#limit-a\">[b]</a>"));
  BOOST_TEST(holds(reasons, "<li id=\"limit-b\"><strong>[a]</strong>"));
  BOOST_TEST(holds(reasons, "<li id=\"limit-a\"><strong>[b]</strong>"));
  BOOST_TEST(reasons.find("that of pears") < reasons.find("that of apples"), reasons);
}

BOOST_AUTO_TEST_CASE(the_index_has_every_value_with_its_error) {
  Document document;
  document.value("price", Value({2.612, 0.001}, fixed(2), "{kr}"));
  document.value("stalls", Value(3, integer()));
  const std::string html = index_html(document.registered());

  for (const char* part :
       {"<p id=\"val-price\">", "<tex>\\qty{2.61}{kr}</tex>, <tex>error $\\le$ \\qty{1.0e-3}{kr}",
        "<p id=\"val-stalls\">", "page\\_html\\_test.cpp:"}) {
    BOOST_TEST(holds(html, part));
  }
}

BOOST_AUTO_TEST_SUITE_END()

// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/document.hpp"

#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>

#include "messages.hpp"

using literate::Column;
using literate::Criterion;
using literate::Document;
using literate::exact;
using literate::fixed;
using literate::integer;
using literate::LimitKind;
using literate::Table;
using literate::Value;
using literate::Verdict;

namespace {

template <typename Register>
std::string refused(Register&& registering) {
  return message_of<literate::Error>(std::forward<Register>(registering));
}

Criterion at_most_one(int number) {
  return Criterion::at_most("count", Value(number, integer()), {1, LimitKind::data, "one"});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(document_test)

BOOST_AUTO_TEST_CASE(invalid_registrations_are_refused_with_line_and_key) {
  Document document;
  document.value("x", Value(1, exact()));
  const std::string twice = refused([&] { document.value("x", Value(2, exact())); });
  BOOST_TEST(holds(twice, "document_test.cpp:"));
  BOOST_TEST(holds(twice, ": value 'x' is registered twice, first at "));
  BOOST_TEST(holds(refused([&] { document.value("nan", Value(std::nan(""), exact())); }),
                   ": value 'nan': nan is not finite"));
  BOOST_TEST(holds(refused([&] { document.value("a b", Value(1, exact())); }),
                   "value 'a b': a name consists of letters, digits, '-' and '_' and '.'"));
  BOOST_TEST(holds(refused([&] {
                     document.table({"a.b", {Column::text("x")}});
                   }),
                   "table 'a.b': a name consists of letters, digits, '-' and '_', and begins"));
  BOOST_TEST(holds(refused([&] { document.figure("f", {.width_cm = 1}); }),
                   "figure 'f': its size is 1 cm by 0 cm: both must be positive"));
  BOOST_TEST(holds(refused([&] { document.check("c", std::vector<Criterion>{}, "s"); }),
                   "check 'c' has no criterion"));
  BOOST_TEST(holds(refused([&] { document.check("c", true, "a{"); }), "check 'c': the braces"));
  BOOST_TEST(holds(refused([&] { document.claim("c", {.criteria = {at_most_one(1)}}); }),
                   "claim 'c' has no route"));
  BOOST_TEST(
      holds(refused([&] { document.claim("c", {.route = "r"}); }), "claim 'c' has no criterion"));
}

BOOST_AUTO_TEST_CASE(faults_are_failed_checks_and_unexpected_verdicts) {
  Document document;
  document.check("good", {at_most_one(1)}, "one at most");
  document.check("bad", {at_most_one(2)}, "one at most");
  document.check("fact", false, "it is so");
  document.claim("expected",
                 {.route = "r", .expected = Verdict::fails, .criteria = {at_most_one(2)}});
  document.claim("unexpected",
                 {.route = "r", .expected = Verdict::holds, .criteria = {at_most_one(2)}});
  const auto faults = document.faults();
  BOOST_REQUIRE(faults.size() == 3);
  BOOST_TEST(holds(faults[0], ": check 'bad' failed: one at most; count: 2 (≤ 1): fails"));
  BOOST_TEST(holds(faults[1], ": check 'fact' failed: it is so"));
  BOOST_TEST(
      holds(faults[2], ": claim 'unexpected': fails, expected holds; count: 2 (≤ 1): fails"));
}

BOOST_AUTO_TEST_CASE(append_keeps_the_order_of_both_parts) {
  Document document, part;
  document.claim("a", {.route = "r", .criteria = {at_most_one(1)}});
  part.claim("b", {.route = "r", .criteria = {at_most_one(1)}});
  part.value("x", Value(1, exact()));
  Document again = part;
  document.append(std::move(part));
  BOOST_TEST(document.claims().at(1).first == "b");
  BOOST_TEST(holds(document.place_of("value", "x"), "document_test.cpp:"));
  BOOST_TEST(holds(refused([&] { document.append(std::move(again)); }), "is registered twice"));
}

BOOST_AUTO_TEST_CASE(a_thread_can_read_the_progress) {
  Document document;
  const auto progress = document.progress_so_far();
  document.progress(3, 8);
  BOOST_TEST(progress->done == 3);
  BOOST_TEST(progress->total == 8);
}

BOOST_AUTO_TEST_SUITE_END()

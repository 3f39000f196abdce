// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/recorded_ages.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "message_of.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(recorded_ages_test)

using namespace literate;

namespace {

// What LaTeX is told of two limits of one claim, the first of which is dated.
std::string told(const std::string& record, const std::string& limit = "at most 1 %") {
  const TemporaryFolder folder;
  if (!record.empty()) folder.write("results.json", record);
  Names names;
  names.case_sha256 = "c1";
  names.claims["far"].limits = {
      {.quantity = "share", .condition = "at most 5", .reason = "choice: x"},
      {.quantity = "ratio", .condition = limit, .reason = "choice: y"}};
  return RecordedAges(folder.path(), names).latex();
}

std::string record(const std::string& of_case, const std::string& age) {
  return R"({"inputs": {"case": ")" + of_case +
         R"("}, "limits": {"claim far: ratio": "at most 1 %"}, "ages": {"claim far: ratio": ")" +
         age + R"("}})";
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_ledger_is_told_of_each_limit_whose_age_is_known) {
  BOOST_TEST(told(record("c1", chosen_after)) ==
             "\\LiterateLimitAge{far}{2}{chosen after the result}\n");
  BOOST_TEST(told(record("c1", older_than_verdict)) ==
             "\\LiterateLimitAge{far}{2}{older than its verdict}\n");
}

BOOST_AUTO_TEST_CASE(what_was_chosen_after_a_result_was_so_in_another_case_too) {
  BOOST_TEST(told(record("c2", chosen_after)) ==
             "\\LiterateLimitAge{far}{2}{chosen after the result}\n");
}

BOOST_AUTO_TEST_CASE(nothing_is_told_without_a_record_or_of_another_case_or_limit) {
  BOOST_TEST(told("") == "");
  BOOST_TEST(told(record("c2", older_than_verdict)) == "");
  BOOST_TEST(told(record("c1", chosen_after), "at most 2 %") == "");
  BOOST_TEST(told(record("c1", "as old as the hills")) == "");
  BOOST_TEST(told(R"({"inputs": {"case": "c1"}, "limits": {}})") == "");
}

BOOST_AUTO_TEST_CASE(what_is_no_record_is_refused) {
  for (const char* text : {"{", "{}", R"({"inputs": {"case": "c1"}, "limits": 3})"}) {
    const std::string message = message_of<sys::OutputError>([&] { told(text); });
    BOOST_TEST(message.ends_with("is no record of results; the check with RECORD=1 writes it anew"),
               message);
  }
}

BOOST_AUTO_TEST_SUITE_END()

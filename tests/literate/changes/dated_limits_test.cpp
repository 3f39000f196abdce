// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/dated_limits.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "holds.hpp"
#include "literate/changes/made_up_paper.hpp"
#include "literate/prose/recorded_ages.hpp"

BOOST_AUTO_TEST_SUITE(dated_limits_test)

using namespace literate;

namespace {

const std::string age_of_far = "claim far: ratio";

// What a record tells of one claim with one criterion.
Manifest results(const std::string& limit, const std::string& verdict = "confirmed") {
  Manifest manifest;
  manifest.project = "rod";
  manifest.inputs = {{"case", "c1"}};
  manifest.verdicts = {{"claim far", verdict}};
  manifest.limits = {{age_of_far, limit}};
  return manifest;
}

Manifest without_claim() {
  Manifest manifest = results("");
  manifest.verdicts.clear();
  manifest.limits.clear();
  return manifest;
}

// A history of records, a commit each.
struct History : MadeUpPaper {
  History(std::initializer_list<Manifest> records) {
    for (const Manifest& one : records) {
      commit(one);
    }
  }
  DatedLimits dated(const Manifest& now, const std::string& reason = "choice: a tenth") const {
    Names names;
    names.claims["far"].place = "rod.cpp:7:3";
    for (const auto& [what, condition] : now.limits) {
      names.claims["far"].limits.push_back(
          {.quantity = what.substr(what.find(": ") + 2), .condition = condition, .reason = reason});
    }
    return dated_limits(folder(), now, names, folder() / "case.toml");
  }
  // «», or what is known of the age of the limit.
  std::string age(const Manifest& now, const std::string& reason = "choice: a tenth") const {
    const DatedLimits all = dated(now, reason);
    return all.ages.contains(age_of_far) ? all.ages.at(age_of_far) : "";
  }
};

const Manifest one_percent = results("at most 1 %"), two_percent = results("at most 2 %"),
               open = results("at most 1 %", "undecided");

}  // namespace

BOOST_AUTO_TEST_CASE(of_a_limit_that_came_with_its_result_nothing_is_known) {
  BOOST_TEST(History({one_percent}).age(one_percent) == "");
  BOOST_TEST(History({without_claim(), one_percent}).age(one_percent) == "");
  BOOST_TEST(History({}).age(one_percent) == "");
}

BOOST_AUTO_TEST_CASE(a_limit_that_another_one_gave_way_to_was_chosen_after_the_result) {
  const History history{one_percent, two_percent, two_percent};

  const DatedLimits found = history.dated(two_percent);

  BOOST_TEST(found.ages.at(age_of_far) == chosen_after);
  BOOST_TEST_REQUIRE(found.chosen_after.size() == 1U);
  const std::string first = history.git({"rev-parse", "HEAD~1"}).substr(0, 12);
  const std::string before = history.git({"rev-parse", "HEAD~2"}).substr(0, 12);
  BOOST_TEST(found.chosen_after[0] ==
             "rod.cpp:7:3: claim far: ratio: the limit was chosen after the result: 'at most 2 %' "
             "came into results.json at commit " +
                 first + ", and commit " + before + " has a result at 'at most 1 %'");
}

BOOST_AUTO_TEST_CASE(a_limit_that_is_not_committed_yet_is_told_as_such) {
  const DatedLimits found = History({one_percent}).dated(two_percent);

  BOOST_TEST(found.ages.at(age_of_far) == chosen_after);
  BOOST_TEST(holds(found.chosen_after.at(0), "is in no committed results.json"));
}

BOOST_AUTO_TEST_CASE(a_limit_that_stood_while_its_claim_was_undecided_is_older_than_the_result) {
  BOOST_TEST(History({without_claim(), open}).age(one_percent) == older_than_verdict);
  BOOST_TEST(History({without_claim(), open, one_percent}).age(one_percent) == older_than_verdict);
  BOOST_TEST(History({without_claim(), open}).age(open) == "");  // it has judged none yet
}

BOOST_AUTO_TEST_CASE(a_limit_that_did_not_stand_since_is_not_older) {
  BOOST_TEST(History({without_claim(), open, two_percent}).age(one_percent) == "");
}

BOOST_AUTO_TEST_CASE(a_limit_that_came_after_an_undecided_verdict_at_another_is_chosen_after_it) {
  BOOST_TEST(History({without_claim(), open, two_percent}).age(two_percent) == chosen_after);
  BOOST_TEST(History({open}).age(two_percent) == chosen_after);
}

BOOST_AUTO_TEST_CASE(before_the_first_record_there_may_have_been_results) {
  BOOST_TEST(History({open}).age(one_percent) == "");
}

BOOST_AUTO_TEST_CASE(of_several_criteria_of_an_undecided_claim_one_may_have_its_result) {
  Manifest both = open, now = one_percent;
  both.limits["claim far: share"] = now.limits["claim far: share"] = "at most 5";
  BOOST_TEST(History({without_claim(), both}).age(now) == "");
}

BOOST_AUTO_TEST_CASE(a_limit_that_came_back_came_with_its_first_result) {
  BOOST_TEST(History({one_percent, two_percent}).age(one_percent) == "");
}

BOOST_AUTO_TEST_CASE(a_limit_that_may_have_moved_with_the_case_is_not_known) {
  Manifest other = two_percent;
  other.inputs = {{"case", "c2"}};
  BOOST_TEST(History({one_percent}).age(other) == "");
  BOOST_TEST(History({one_percent, other, two_percent}).age(two_percent) == "");
  other.inputs.clear();  // as records of earlier versions
  BOOST_TEST(History({other}).age(one_percent) == "");
}

BOOST_AUTO_TEST_CASE(a_case_with_other_comments_is_the_same_case) {
  const std::string plain = "angle = 90\n", explained = "# in degrees\nangle = 90\n";
  const auto of_case = [](Manifest one, const std::string& text) {
    one.inputs["case"] = sys::sha256_of_text(text);
    return one;
  };
  History history{};
  history.write("case.toml", plain);
  history.commit(of_case(one_percent, plain));

  history.write("case.toml", explained);
  BOOST_TEST(history.age(of_case(two_percent, explained)) == chosen_after);
  history.commit(of_case(two_percent, explained));
  BOOST_TEST(history.age(of_case(two_percent, explained)) == chosen_after);

  const std::string steeper = "angle = 91\n";
  history.write("case.toml", steeper);
  BOOST_TEST(history.age(of_case(results("at most 3 %"), steeper)) == "");
}

BOOST_AUTO_TEST_CASE(a_limit_that_the_run_computes_is_not_known_if_it_moves) {
  BOOST_TEST(History({one_percent}).age(two_percent, "theory: c/a, the strip") == "");
  BOOST_TEST(History({one_percent}).age(two_percent, "method: the grid's error") == "");
  BOOST_TEST(History({one_percent}).age(two_percent, "data: printed") == chosen_after);
  BOOST_TEST(History({without_claim(), open}).age(one_percent, "theory: c/a, the strip") ==
             older_than_verdict);
}

BOOST_AUTO_TEST_CASE(a_squash_leaves_nothing_to_know) {
  History history{one_percent, two_percent};
  history.git({"checkout", "-q", "--orphan", "squashed"});
  history.commit();
  BOOST_TEST(history.age(two_percent) == "");
}

BOOST_AUTO_TEST_CASE(a_rebase_that_keeps_the_commits_keeps_what_is_known) {
  History history{without_claim(), open, one_percent};
  history.git({"switch", "-qc", "words", "HEAD~2"});
  history.write("a.tex", "Words.\n");
  history.commit();
  history.git({"rebase", "-q", "words", "main"});
  BOOST_TEST(history.age(one_percent) == older_than_verdict);
}

BOOST_AUTO_TEST_CASE(a_record_that_cannot_be_read_leaves_nothing_to_know) {
  History history{without_claim(), open};
  history.write("results.json", "{");
  history.commit();
  history.commit(one_percent);
  BOOST_TEST(history.age(one_percent) == "");
}

BOOST_AUTO_TEST_CASE(a_record_that_was_removed_meanwhile_is_passed_over) {
  History history{without_claim(), open};
  history.git({"rm", "-q", "results.json"});
  history.commit();
  history.commit(one_percent);
  BOOST_TEST(history.age(one_percent) == older_than_verdict);
}

BOOST_AUTO_TEST_SUITE_END()

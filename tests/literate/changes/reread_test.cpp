// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/changes/reread.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "holds.hpp"
#include "literate/changes/made_up_paper.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "system/process.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(reread_test)

using namespace literate;
namespace fs = std::filesystem;

namespace {

const std::string first_words = "The peak is \\val{peak}.\n\nIt holds \\claim{far}.\n";

Manifest results(double peak, const std::string& verdict = "confirmed") {
  Manifest manifest;
  manifest.project = "rod";
  manifest.numbers = {{"peak",
                       {.number = peak,
                        .abs_error = 0.1,
                        .printed = std::to_string(static_cast<int>(peak)) + " psi"}}};
  manifest.verdicts = {{"claim far", verdict}};
  return manifest;
}

class Paper : public MadeUpPaper {
 public:
  Reread reread(const Manifest& now) const {
    return sentences_to_reread(folder(), now, folder() / "case.toml");
  }
};

// Whether there is one line, with this part.
boost::test_tools::assertion_result are_one_with(const std::vector<std::string>& lines,
                                                 const std::string& part) {
  if (lines.size() == 1) return holds(lines[0], part);
  boost::test_tools::assertion_result none(false);
  none.message() << lines.size() << " lines";
  return none;
}

// One whose words were written beside a peak of 10 psi.
struct Written : Paper {
  Written() {
    write("a.tex", first_words);
    commit(results(10));
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_value_that_moved_beyond_its_error_is_listed_with_its_sentence) {
  const Written paper;

  const Reread found = paper.reread(results(12));

  BOOST_TEST(are_one_with(
      found.sentences, "a.tex:1: read this sentence again: value peak is 12 psi, and was 10 psi"));
  BOOST_TEST(found.unknown.empty());
}

BOOST_AUTO_TEST_CASE(each_sentence_of_a_line_is_listed) {
  Paper paper;
  paper.write("a.tex", "It holds \\claim{far}. So we say \\claim{far}.\n");
  paper.commit(results(10));

  BOOST_TEST(paper.reread(results(10, "refuted")).sentences.size() == 2U);
}

BOOST_AUTO_TEST_CASE(what_the_record_beside_a_sentence_does_not_have_is_held_against_the_last) {
  Written paper;
  paper.write("b.tex", "The width is \\val{width}.\n");
  paper.commit();  // before its value is recorded
  Manifest later = results(10);
  later.numbers["width"] = {.number = 3, .abs_error = 0.1, .printed = "3 in"};
  paper.commit(later);
  later.numbers["width"] = {.number = 5, .abs_error = 0.1, .printed = "5 in"};

  const Reread found = paper.reread(later);

  BOOST_TEST(
      are_one_with(found.sentences,
                   "value width is 5 in, and was 3 in in results.json when it was last recorded"));
  BOOST_TEST(are_one_with(
      found.unknown,
      "1 sentence, such as " + paper.folder().filename().string() + "/b.tex:1 of commit "));
  BOOST_TEST(holds(found.unknown[0], "its results.json does not have all that they print"));
}

BOOST_AUTO_TEST_CASE(a_sentence_whose_lines_and_neighbours_changed_keeps_its_age) {
  const Written paper;
  const auto is_listed = [&] {
    return are_one_with(paper.reread(results(12)).sentences, "was 10 psi");
  };
  paper.write("a.tex", "Our peak\nis here. The peak\nis \\val{peak}.\n\nIt holds \\claim{far}.\n");
  BOOST_TEST(is_listed());

  Written committed;
  committed.write("a.tex", "Another one. The peak\nis \\val{peak}.\n\nIt holds \\claim{far}.\n");
  committed.commit(results(12));
  committed.write("a.tex", "The\npeak is \\val{peak}.\n\nIt holds \\claim{far}.\n");
  committed.commit();

  const Reread found = committed.reread(results(12));
  BOOST_TEST(are_one_with(found.sentences, "was 10 psi"));
}

BOOST_AUTO_TEST_CASE(words_that_are_older_than_the_first_record_are_held_against_it_and_named) {
  Paper paper;
  paper.write("a.tex", first_words);
  paper.commit();
  paper.commit(results(10));

  const Reread found = paper.reread(results(12));

  BOOST_TEST(
      are_one_with(found.sentences, "was 10 psi in results.json when it was first recorded, at "));
  BOOST_TEST(
      are_one_with(found.unknown, "they are no younger than the first record, that of commit "));
}

BOOST_AUTO_TEST_CASE(such_words_keep_their_age_when_what_stands_beside_them_changes) {
  Paper paper;
  paper.write("a.tex", "Look here. " + first_words);
  paper.commit();
  paper.commit(results(10));
  const auto is_listed = [&] {
    return are_one_with(paper.reread(results(12)).sentences,
                        "was 10 psi in results.json when it was first recorded, at ");
  };

  paper.write("a.tex", "Look there. " + first_words);
  BOOST_TEST(is_listed());
  paper.commit(results(12));
  BOOST_TEST(is_listed());
  paper.write("a.tex", "Look\nthere. The\npeak is \\val{peak}.\n\nIt holds \\claim{far}.\n");
  BOOST_TEST(is_listed());
}

BOOST_AUTO_TEST_CASE(a_record_of_another_case_than_its_commit_has_is_none) {
  Paper paper;
  paper.write("case.toml", "load = 2\n");
  paper.write("a.tex", first_words);
  Manifest of_another = results(10);
  of_another.inputs["case"] = sys::sha256_of_text("load = 1\n");
  paper.commit(of_another);
  const Reread other = paper.reread(results(12));
  BOOST_TEST(other.sentences.empty());
  BOOST_TEST(are_one_with(other.unknown, "its results.json is of another case"));

  Paper same;
  same.write("case.toml", "load = 1\n");
  same.write("a.tex", first_words);
  same.commit(of_another);
  BOOST_TEST(same.reread(results(12)).sentences.size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_value_that_moved_within_its_error_is_not) {
  BOOST_TEST(Written().reread(results(10.15)).sentences.empty());
}

BOOST_AUTO_TEST_CASE(a_value_that_prints_as_before_is_not) {
  BOOST_TEST(Written().reread(results(10.9)).sentences.empty());
}

BOOST_AUTO_TEST_CASE(a_flag_that_turned_is_listed_with_all_sentences_of_its_branches) {
  const auto with_flag = [](const std::string& flag) {
    Manifest manifest = results(10);
    manifest.texts["flag near"] = flag;
    return manifest;
  };
  Paper paper;
  paper.write("a.tex", "\\ifflag{near}{It is near.\nIt is close.}{It is far.}\nIt is.\n");
  paper.commit(with_flag("yes"));

  const Reread found = paper.reread(with_flag("no"));

  BOOST_TEST_REQUIRE(found.sentences.size() == 2U);
  BOOST_TEST(
      holds(found.sentences[0], "a.tex:1: read this sentence again: flag near is no, and was yes"));
  BOOST_TEST(holds(found.sentences[1], "a.tex:2: "));
}

BOOST_AUTO_TEST_CASE(a_verdict_that_turned_is_listed) {
  const Reread found = Written().reread(results(10, "refuted"));

  BOOST_TEST(
      are_one_with(found.sentences,
                   "a.tex:3: read this sentence again: claim far is refuted, and was confirmed"));
}

BOOST_AUTO_TEST_CASE(a_value_that_came_back_is_not_listed) {
  Written paper;
  paper.commit(results(12));
  paper.commit(results(10));

  BOOST_TEST(paper.reread(results(10)).sentences.empty());
}

BOOST_AUTO_TEST_CASE(other_words_are_read_where_they_are_written) {
  Written paper;
  paper.record(results(12));
  paper.write("a.tex", "The largest is \\val{peak}.\n\nIt holds \\claim{far}.\n");

  BOOST_TEST(paper.reread(results(12)).sentences.empty());  // not committed yet
  paper.commit();
  BOOST_TEST(paper.reread(results(12)).sentences.empty());
  BOOST_TEST(paper.reread(results(10)).sentences.size() == 1U);
}

BOOST_AUTO_TEST_CASE(another_indentation_and_another_file_are_no_other_words) {
  Written paper;
  paper.record(results(12));
  paper.write("a.tex", "The   peak is  \\val{peak}.\n\nIt holds \\claim{far}.\n");
  paper.commit();
  paper.git({"mv", "a.tex", "b.tex"});
  paper.commit();

  const Reread found = paper.reread(results(12));

  BOOST_TEST(are_one_with(found.sentences, "b.tex:1: "));
}

BOOST_AUTO_TEST_CASE(a_value_with_another_name_was_read_by_who_gave_it) {
  Written paper;
  Manifest now = results(10);
  now.numbers["summit"] = now.numbers["peak"];
  now.numbers.erase("peak");
  paper.record(now);
  paper.write("a.tex", "The peak is \\val{summit}.\n\nIt holds \\claim{far}.\n");
  paper.commit();

  const Reread found = paper.reread(now);

  BOOST_TEST(found.sentences.empty());
  BOOST_TEST(found.unknown.empty());
}

BOOST_AUTO_TEST_CASE(words_that_were_rebased_upon_newer_results_are_not_known) {
  Written paper;
  paper.git({"switch", "-qc", "words"});
  paper.write("a.tex", "About ten: \\val{peak}.\n\nIt holds \\claim{far}.\n");
  paper.commit();
  paper.git({"switch", "-q", "main"});
  paper.commit(results(12));
  paper.git({"switch", "-q", "words"});
  paper.wait();
  paper.git({"rebase", "-q", "main"});

  const Reread found = paper.reread(results(12));

  BOOST_TEST(found.sentences.empty());
  BOOST_TEST(are_one_with(found.unknown, ": it was rewritten"));
}

BOOST_AUTO_TEST_CASE(words_that_were_rebased_upon_the_same_results_are_known) {
  Written paper;
  paper.git({"switch", "-qc", "words"});
  paper.write("a.tex", "About ten: \\val{peak}.\n\nIt holds \\claim{far}.\n");
  paper.commit();
  paper.git({"switch", "-q", "main"});
  paper.write("other", "text");
  paper.commit();
  paper.git({"switch", "-q", "words"});
  paper.wait();
  paper.git({"rebase", "-q", "main"});

  const Reread found = paper.reread(results(12));

  BOOST_TEST(found.unknown.empty());
  BOOST_TEST(found.sentences.size() == 1U);
}

BOOST_AUTO_TEST_CASE(words_are_not_known_where_history_begins_with_them) {
  Written paper;
  paper.git({"checkout", "-q", "--orphan", "squashed"});
  paper.commit();

  const Reread found = paper.reread(results(12));

  BOOST_TEST(are_one_with(found.unknown, "2 sentences, such as "));
  BOOST_TEST(holds(found.unknown[0], "/a.tex:1: they are "));
  BOOST_TEST(holds(found.unknown[0], "they are no younger than the first record, that of commit "));
  BOOST_TEST(
      are_one_with(found.sentences, "was 10 psi in results.json when it was first recorded"));
}

BOOST_AUTO_TEST_CASE(without_history_nothing_is_known) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "plain/a.tex", first_words);
  const Written paper;
  sys::run(
      {.program = "git",
       .arguments = {"clone", "-q", "--depth=1", "file://" + fs::canonical(paper.folder()).string(),
                     (scratch / "shallow").string()}});

  const auto reread_in = [&](const char* folder) {
    return sentences_to_reread(scratch / folder, results(12), scratch / "case.toml");
  };
  const Reread plain = reread_in("plain"), shallow = reread_in("shallow");

  BOOST_TEST(!plain.has_history);
  BOOST_TEST(plain.unknown.size() == 1U);
  BOOST_TEST(!shallow.has_history);
  BOOST_TEST(shallow.unknown.size() == 1U);
  BOOST_TEST(shallow.sentences.empty());
}

BOOST_AUTO_TEST_CASE(a_reader_ticks_a_sentence_off_at_the_values_that_it_prints) {
  const Written paper;
  const std::string said = paper.reread(results(12)).sentences.at(0);
  const std::string tick = said.substr(said.find("read.csv: ") + 10);
  BOOST_TEST(holds(tick, ",value peak,12 psi,your name"));

  paper.write("read.csv", tick + "\n");

  BOOST_TEST(paper.reread(results(12)).sentences.empty());
  BOOST_TEST(paper.reread(results(13)).sentences.size() == 1U);
  paper.write("read.csv", "a,b\n");
  BOOST_CHECK_THROW(paper.reread(results(12)), sys::SourceError);
}

BOOST_AUTO_TEST_CASE(results_are_those_that_sentences_print) {
  Manifest all = results(10);
  all.inputs = {{"a.cpp", "1"}};
  all.outputs = {{"rod.pdf", "2"}};
  all.numbers["table t, row 1, column 1"] = {.number = 1, .abs_error = 0, .printed = "1"};
  all.verdicts["check k"] = "passed";

  BOOST_TEST(manifest_json(printed_results(all)) == manifest_json(results(10)));
}

BOOST_AUTO_TEST_SUITE_END()

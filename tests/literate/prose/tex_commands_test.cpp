// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/tex_commands.hpp"

#include <fmt/core.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(tex_commands_test)

using namespace literate;
using boost::test_tools::per_element;

namespace {

// Each use as «line:column name argument», and each branch it stands in as «?flag» or «!flag».
std::vector<std::string> uses_in(const std::string& latex) {
  std::vector<std::string> uses;
  for (const TexCommand& use : commands_in(latex, {"val", "tab"})) {
    std::string text = fmt::format("{}:{} {} {}", use.line, use.column, use.name, use.argument);
    for (const Branch& branch : use.branches) text += (branch.is_yes ? " ?" : " !") + branch.flag;
    uses.push_back(text);
  }
  return uses;
}

using Uses = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_CASE(uses_come_in_order_with_their_places) {
  BOOST_TEST(uses_in("\\val{a} é\\tab { b }\\fig{c}\n{\\val{d}}") ==
                 (Uses{"1:1 val a", "1:10 tab b", "2:2 val d"}),
             per_element());
}

BOOST_AUTO_TEST_CASE(a_name_without_a_plain_argument_is_no_use) {
  BOOST_TEST(
      uses_in("\\newcommand{\\val}[1]{x}\\def\\tab#1{\\val{#1}}\\value{a}\\val{}\\val").empty());
}

BOOST_AUTO_TEST_CASE(an_option_that_is_a_parameter_is_used_where_it_is_given) {
  const std::string definition = "\\newcommand{\\dg}[1]{\\val[digits=#1]{x}}";
  BOOST_TEST(uses_in(definition).empty());
  const auto uses = commands_in(definition + "\\dg{3}", {"val"}, own_commands_in(definition));
  BOOST_TEST_REQUIRE(uses.size() == 1U);
  BOOST_TEST(uses[0].options == "digits=3");
}

BOOST_AUTO_TEST_CASE(comments_and_verbatim_text_hold_no_uses) {
  BOOST_TEST(uses_in("% \\val{a}\n\\verb|\\val{b}|\\begin{verbatim}\n\\val{c}\n\\end{verbatim}"
                     "50\\%\\val{d}") == Uses{"4:19 val d"},
             per_element());
}

BOOST_AUTO_TEST_CASE(commands_of_the_documents_own_are_uses_of_what_they_expand_to) {
  const std::string definitions =
      "\\newcommand{\\len}[1]{\\val{len.#1}}\\newcommand*\\both[2][a]{\\len{#1} and \\len{#2}}"
      "\\def\\two#1#2{\\tab{#2}\\ifflag{#1}{}{\\val{x}}}\\newcommand\\again{\\again\\val{y}}% "
      "\\def\\no{\\val{n}}\n";
  const auto uses = [&](const std::string& latex) {
    std::vector<std::string> found;
    for (const TexCommand& use : commands_in(latex, {"val", "tab"}, own_commands_in(definitions))) {
      std::string text = fmt::format("{} {} {}", use.column, use.name, use.argument);
      for (const Branch& branch : use.branches) text += (branch.is_yes ? " ?" : " !") + branch.flag;
      found.push_back(text);
    }
    return found;
  };
  BOOST_TEST(uses("a \\len{b}, \\no") == (Uses{"3 val len.b"}), per_element());
  BOOST_TEST(uses("\\both{b} \\both[c] {d}") ==
                 (Uses{"1 val len.a", "1 val len.b", "10 val len.c", "10 val len.d"}),
             per_element());
  BOOST_TEST(uses("\\ifflag{g}{\\two{f} {t}}{}") == (Uses{"12 tab t ?g", "12 val x ?g !f"}),
             per_element());
  BOOST_TEST(uses("\\again").size() == 8U);
}

BOOST_AUTO_TEST_CASE(
    commands_by_NewDocumentCommand_are_own_ones_as_far_as_newcommand_could_say_them) {
  const auto uses = [](const std::string& definition, const std::string& latex) {
    std::vector<std::string> found;
    for (const TexCommand& use : commands_in(latex, {"val"}, own_commands_in(definition))) {
      found.push_back(use.argument);
    }
    return found;
  };
  BOOST_TEST(uses("\\NewDocumentCommand{\\len}{m}{\\val{len.#1}}", "\\len{b}") == Uses{"len.b"},
             per_element());
  BOOST_TEST(uses("\\NewDocumentCommand\\both{ O{a} m }{\\val{#1}\\val{#2}}",
                  "\\both{b}\\both[c]{d}") == (Uses{"a", "b", "c", "d"}),
             per_element());
  BOOST_TEST(uses("\\DeclareDocumentCommand{\\n}{}{\\val{n}}", "\\n") == Uses{"n"}, per_element());
  BOOST_TEST(uses("\\NewDocumentCommand{\\len}{s m}{\\val{#2}}", "\\len*{b}").empty());
}

BOOST_AUTO_TEST_CASE(a_use_knows_its_branches_outermost_first) {
  BOOST_TEST(uses_in("\\ifflag{f}{\\val{a}\\ifflag{g}{}{{\\val{b}}}}% }\n {\\val{c}}{\\val{d}}") ==
                 (Uses{"1:12 val a ?f", "1:33 val b ?f !g", "2:3 val c !f", "2:12 val d"}),
             per_element());
}

BOOST_AUTO_TEST_CASE(what_stands_between_the_groups_ends_the_condition) {
  BOOST_TEST(
      uses_in("\\ifflag{f}{\\val{a}} and {\\val{b}}") == (Uses{"1:12 val a ?f", "1:26 val b"}),
      per_element());
  BOOST_TEST(uses_in("\\ifflag{f}{\\val{a}}\\%{\\val{b}}") == (Uses{"1:12 val a ?f", "1:23 val b"}),
             per_element());
}

BOOST_AUTO_TEST_SUITE_END()

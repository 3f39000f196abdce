// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/latex_numbers.hpp"

#include <boost/test/unit_test.hpp>

#include "message_of.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(latex_numbers_test)

using namespace literate;

namespace {

struct Aux {
  explicit Aux(const std::string& text) { folder.write("paper.aux", text); }
  LatexNumbers read() const { return LatexNumbers(folder / "paper.aux"); }
  TemporaryFolder folder;
};

}  // namespace

BOOST_AUTO_TEST_CASE(
    numbers_come_in_the_order_of_the_pdf_wherever_floats_and_included_files_stand) {
  const Aux aux(
      "\\LiterateNumber{section}{I}{document}{}{2}\n"
      "\\LiterateNumber{figure}{1}{figure}{FIG.}{1}\n"
      "\\LiterateNumber{section}{II}{document}{}{3}\n"
      "\\LiterateNumber{table}{2}{longtable}{Table}{9}\n"
      "\\LiterateNumber{table}{1}{table}{Table}{4}\n"
      "\\LiterateNumber{equation}{3}{subequations}{}{5}\n"
      "\\LiterateNumber{equation}{3a}{equation}{}{6}\n\\@input{part.aux}\n");
  aux.folder.write("part.aux", "\\LiterateNumber{section}{III}{document}{}{7}\n");
  LatexNumbers numbers = aux.read();

  for (const char* number : {"I", "II", "III"})
    BOOST_TEST(numbers.take("section").number == number);
  BOOST_TEST(!numbers.next("section"));
  BOOST_TEST(numbers.take("table").number == "1");
  BOOST_TEST(numbers.next("table")->environment == "longtable");
  BOOST_TEST(numbers.take("equation").number == "3a");  // the whole of its parts is none
  BOOST_TEST(numbers.left() == "1 figure, 1 table");
  BOOST_TEST(numbers.take("figure").shown == "FIG.");
}

BOOST_AUTO_TEST_CASE(the_counter_of_a_packages_float_is_that_of_its_list) {
  LatexNumbers numbers =
      Aux("\\LiterateNumber{figure}{1}{figure}{Figure}{1}\n"
          "\\@writefile{lof}{\\contentsline {figure}{\\numberline {1}{A}}{1}{figure.1}}\n"
          "\\LiterateNumber{algocf}{1}{lrbox}{Algorithm}{2}\n"
          "\\@writefile{loa}{\\contentsline {algocf}{\\numberline {1}{Sort}}{1}{algocf.1}}\n"
          "\\LiterateNumber{algocfline}{1}{algorithm}{}{3}\n")
          .read();

  BOOST_TEST(numbers.captioned("algorithm") == "algocf");
  numbers.take("algocf");
  BOOST_TEST(message_of<sys::InputError>([&] { numbers.captioned("algorithm"); }) ==
             "the PDF has no further number for a caption of 'algorithm': it was made from another "
             "state of the document");
  // The lines of an algorithm are no numbers of the page.
  BOOST_TEST(numbers.left() == "1 figure");
}

BOOST_AUTO_TEST_CASE(what_the_pdf_does_not_have_tells_another_state) {
  LatexNumbers numbers = Aux("\\relax\n").read();

  BOOST_TEST(message_of<sys::InputError>([&] { numbers.take("equation"); }) ==
             "the PDF has no further number of a equation: it was made from another state of the "
             "document");
  BOOST_CHECK_THROW(numbers.label("eq:x"), sys::InputError);
  BOOST_CHECK_THROW(numbers.citation("x"), sys::InputError);
}

BOOST_AUTO_TEST_CASE(labels_names_and_citations_are_those_of_hyperref_cleveref_and_natbib) {
  const LatexNumbers numbers =
      Aux("\\newlabel{eq:a}{{{3$'$}}{2}{Two}{equation.1}{}}\n"
          "\\newlabel{eq:a@cref}{{[equation][2][1]3$'$}{[1][2][]2}}\n"
          "\\newlabel{eq:b}{{4}{2}}\n\\newlabel{eq:b@cref}{{[equation][3][1]4}{[1][2][]2}}\n"
          "\\LiterateName{equation}{eq.}{eqs.}{\\MakeUppercase    []{e}q.}{Eqs.}\n"
          "\\LiterateName{table}{table}{tables}{\\MakeUppercase {t}able}{Tables}\n"
          "\\bibcite{a}{7}\n\\bibcite{b}{{8}{2001}{Curie}{}}\n")
          .read();

  BOOST_TEST(numbers.label("eq:a").number == "3$'$");
  BOOST_TEST(numbers.label("eq:a").title == "Two");
  BOOST_TEST(numbers.label("eq:a").type == "equation");
  BOOST_TEST(numbers.follows("eq:a", "eq:b"));
  BOOST_TEST(!numbers.follows("eq:b", "eq:a"));
  BOOST_TEST(numbers.names("equation")[2] == "Eq.");
  BOOST_TEST(numbers.names("equation")[3] == "Eqs.");
  BOOST_TEST(numbers.names("table")[2] == "Table");
  BOOST_TEST(numbers.citation("a")[0] == "7");
  BOOST_TEST(numbers.citation("b")[2] == "Curie");
}

BOOST_AUTO_TEST_SUITE_END()

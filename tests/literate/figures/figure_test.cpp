// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/figure.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <locale>
#include <stdexcept>

#include "holds.hpp"
#include "literate/document/document.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(figure_test)

using namespace literate;

namespace {

struct CommaLocale : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

const std::vector<double> x{0, 0.1, 1.0 / 3};
const std::vector<double> y{1e-300, -2.5, literate::gap};

Figure curve() {
  return {.width_cm = 6, .height_cm = 4.5, .data = {{"curve", {{"x", x}, {"y", y}}}}};
}

std::string refusal_of(const Figure& figure) {
  return message_of<std::logic_error>([&] { require_drawable(figure); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(data_files_hold_every_digit_in_any_locale) {
  const TemporaryFolder scratch;
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaLocale));

  write_figure(scratch.path(), "f", curve());
  std::locale::global(before);

  BOOST_TEST(sys::read_file(scratch / "curve.csv") ==
             "x,y\n0,1e-300\n0.1,-2.5\n0.3333333333333333,nan\n");
  BOOST_TEST(holds(sys::read_file(scratch / "f.gp"), " : 4.5\n"));
}

BOOST_AUTO_TEST_CASE(a_surface_has_a_blank_line_after_each_row_but_the_last) {
  const TemporaryFolder scratch;
  Figure figure = curve();
  figure.data = {{"surface", {{{"x", {1, 2, 1, 2}}, {"z", {3, 3, 4, 4}}}, 2}}};

  write_figure(scratch.path(), "f", figure);

  BOOST_TEST(sys::read_file(scratch / "surface.csv") == "x,z\n1,3\n2,3\n\n1,4\n2,4\n");
}

BOOST_AUTO_TEST_CASE(scripts_find_data_numbers_and_texts_as_variables) {
  const TemporaryFolder scratch;
  Figure figure = curve();
  figure.numbers = {{"two", 2}, {"small", 1e-7}, {"none", literate::gap}};
  figure.texts = {{"unit", "\\,in"}, {"title", "Hertz' pressure"}};

  write_figure(scratch.path(), "f", figure);

  const std::string prelude = sys::read_file(scratch / "f.gp");
  // 2.0, because gnuplot takes 2 for an integer and 1/2 for 0.
  for (const char* line :
       {"curve = 'curve.csv'\n", "two = 2.0\n", "small = 1e-07\n", "none = NaN\n",
        "unit = '\\,in'\n", "title = 'Hertz'' pressure'\n", "load 'script.gp'\n"}) {
    BOOST_TEST(holds(prelude, line));
  }
}

BOOST_AUTO_TEST_CASE(what_no_script_could_read_is_refused_by_name) {
  Figure figure = curve();
  figure.height_cm = 0;
  BOOST_TEST(holds(refusal_of(figure), "6 cm by 0 cm"));
  figure = curve();
  figure.numbers["2nd"] = 1;
  BOOST_TEST(holds(refusal_of(figure), "'2nd'"));
  figure = curve();
  figure.texts["curve"] = "twice";
  BOOST_TEST(holds(refusal_of(figure), "'curve' is given twice"));
  figure = curve();
  figure.numbers["far"] = std::numeric_limits<double>::infinity();
  BOOST_TEST(holds(refusal_of(figure), "'far' is inf: must be finite"));
  figure.numbers["far"] = std::log(-1.0);
  BOOST_TEST(holds(refusal_of(figure), "'far' is"));
  figure = curve();
  figure.data["curve"].columns[1].second[1] = std::sqrt(-1.0);
  BOOST_TEST(holds(refusal_of(figure), "data 'curve': column 'y', point 2 is"));
  figure.data["curve"].columns[1].second[1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(holds(refusal_of(figure), "must be finite, or literate::gap where no point is"));
  figure = curve();
  figure.texts["title"] = "two\nlines";
  BOOST_TEST(holds(refusal_of(figure), "'title' has more than one line"));
}

BOOST_AUTO_TEST_CASE(columns_must_be_there_be_equally_long_and_have_names_of_their_own) {
  Figure figure = curve();
  figure.data["none"] = {};
  BOOST_TEST(holds(refusal_of(figure), "'none' has no columns"));
  figure.data["none"] = {{"x", {}}};
  BOOST_TEST(holds(refusal_of(figure), "'none' has no points"));
  figure.data = {{"long", {{"x", x}, {"y", {1}}}}};
  BOOST_TEST(holds(refusal_of(figure), "'x' has 3 points and 'y' has 1"));
  figure.data = {{"equal", {{"x", x}, {"x", x}}}};
  BOOST_TEST(holds(refusal_of(figure), "'equal' has two columns 'x'"));
  figure.data = {{"rows", {{{"x", x}}, 2}}};
  BOOST_TEST(holds(refusal_of(figure), "3 points do not make rows of 2"));
}

BOOST_AUTO_TEST_CASE(a_refusal_names_figure_and_place_of_registration) {
  Document document;

  const std::string message = message_of<std::logic_error>([&] {
    document.figure("empty", {.width_cm = 6, .height_cm = 4, .data = {{"curve", {}}}});
  });

  BOOST_TEST(holds(message, "figure_test.cpp:"));
  BOOST_TEST(holds(message, "figure 'empty': data 'curve' has no columns"));
}

BOOST_AUTO_TEST_CASE(a_folder_that_cannot_be_written_is_an_output_error) {
  const TemporaryFolder scratch;
  sys::write_file_atomically(scratch / "file", "");

  BOOST_CHECK_THROW(write_figure(scratch / "file", "f", curve()), sys::OutputError);
  BOOST_CHECK_THROW(write_figure(scratch / "file", "f", {.width_cm = 1, .height_cm = 1}),
                    sys::OutputError);
}

BOOST_AUTO_TEST_SUITE_END()

// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/gnuplot.hpp"

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cstdlib>
#include <locale>
#include <stdexcept>
#include <thread>

#include "literate/document/document.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_file.hpp"

using namespace literate;
namespace fs = std::filesystem;

namespace {

struct CommaLocale : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

const std::vector<double> x{0, 0.1, 1.0 / 3};
const std::vector<double> y{1e-300, -2.5, 1e6};

void draw_curve(Plot& plot) {
  plot << "set label '$\\nu$' at " << 0.1 << ",0\n";
  plot << "plot " << plot.data("curve", {x, y}) << " with lines\n";
}

void draw_nonsense(Plot& plot) {
  plot << "set nonsense\n";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(data_files_hold_every_digit_in_any_locale) {
  const TemporaryFolder scratch;
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaLocale));

  draw_figures(scratch.path(), {{"f", {6, 4.5, draw_curve}}});
  std::locale::global(before);

  BOOST_TEST(sys::read_file(scratch / "f.curve.dat") ==
             "0 1e-300\n0.1 -2.5\n0.3333333333333333 1e+06\n");
  BOOST_TEST(has(sys::read_file(scratch / "f.gp"), "size 6cm,4.5cm\nset output 'f.tex'\n"));
  BOOST_TEST(has(sys::read_file(scratch / "f.gp"), "at 0.1,0\nplot 'f.curve.dat' with lines\n"));
}

BOOST_AUTO_TEST_CASE(a_figure_names_its_graphic_without_a_folder) {
  const TemporaryFolder scratch;
  draw_figures(scratch.path(), {{"f", {6, 4, draw_curve}}});

  const std::string tex = sys::read_file(scratch / "f.tex");

  BOOST_TEST(has(tex, "]{f}}%"));
  BOOST_TEST(!has(tex, scratch.path().string()));
}

BOOST_AUTO_TEST_CASE(a_figure_has_the_same_bytes_at_another_time) {
  const TemporaryFolder scratch;
  draw_figures(scratch.path(), {{"f", {6, 4, draw_curve}}});
  const std::string first = sys::sha256_of_file(scratch / "f.pdf");
  fs::remove(scratch / "f.curve.dat");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));

  draw_figures(scratch.path(), {{"f", {6, 4, draw_curve}}});

  BOOST_TEST(sys::sha256_of_file(scratch / "f.pdf") == first);
  BOOST_TEST(has(sys::read_file(scratch / "f.pdf"), "D:19700101000000Z"));
}

BOOST_AUTO_TEST_CASE(an_error_has_script_name_line_and_message) {
  const TemporaryFolder scratch;

  const std::string message = message_of<sys::ToolError>([&] {
    draw_figures(scratch.path(), {{"z", {6, 4, [](Plot& plot) { plot << "plot 'none'\n"; }}},
                                  {"b", {6, 4, draw_nonsense}},
                                  {"a", {6, 4, draw_curve}}});
  });

  BOOST_TEST(has(message, "figure 'b'"));
  BOOST_TEST(has(message, "\"b.gp\" line 4: unrecognized option"));
  BOOST_TEST(!has(message, "'z'"));
}

BOOST_AUTO_TEST_CASE(a_curve_that_gnuplot_only_warns_about_is_an_error) {
  const TemporaryFolder scratch;
  const Figure figure{6, 4, [](Plot& plot) { plot << "plot sin(x), 'none.dat'\n"; }};

  const std::string message = message_of<sys::ToolError>([&] {
    draw_figures(scratch.path(), {{"f", figure}});
  });

  BOOST_TEST(has(message, "none.dat"));
}

BOOST_AUTO_TEST_CASE(data_must_be_new_and_have_equal_columns) {
  const TemporaryFolder scratch;
  Plot plot(scratch.path(), "f", 6, 4);
  plot.data("a", {x, y});

  BOOST_CHECK_THROW(plot.data("a", {x, y}), std::logic_error);
  BOOST_CHECK_THROW(plot.data("b", {x, std::vector<double>{1}}), std::invalid_argument);
  BOOST_CHECK_THROW(plot.data("c", {}), std::invalid_argument);
  BOOST_CHECK_THROW(Plot(scratch / "none", "f", 6, 4), sys::OutputError);
}

BOOST_AUTO_TEST_CASE(a_broken_figure_leaves_the_old_document_untouched) {
  const TemporaryFolder scratch;
  Document good;
  good.figure("f", 6, 4, draw_curve);
  good.write(scratch / "out");
  const std::string before = sys::read_file(scratch / "out/figures/f.gp");
  Document bad;
  bad.figure("f", 6, 4, draw_nonsense);

  BOOST_CHECK_THROW(bad.write(scratch / "out"), sys::ToolError);

  BOOST_TEST(sys::read_file(scratch / "out/figures/f.gp") == before);
  BOOST_TEST(!fs::exists(scratch / "out.part"));
}

BOOST_AUTO_TEST_CASE(a_missing_gnuplot_is_a_tool_error_naming_the_setup) {
  const TemporaryFolder scratch;
  const std::string path = std::getenv("PATH");
  setenv("PATH", scratch.path().c_str(), 1);

  const std::string message = message_of<sys::ToolError>([&] { run_gnuplot(scratch.path(), "f"); });
  setenv("PATH", path.c_str(), 1);

  BOOST_TEST(message == "gnuplot is not installed; 'make setup' installs it");
}

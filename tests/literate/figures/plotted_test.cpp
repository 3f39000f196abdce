// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/figures/plotted.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "literate/figures/draw.hpp"
#include "literate/figures/figure.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(plotted_test)

using namespace literate;
using Points = std::vector<std::pair<double, double>>;

namespace {

/// What is plotted by a script that has the blocks `curve` and `dots`.
struct Drawn {
  explicit Drawn(const std::string& script) {
    const Figure figure{.width_cm = 10,
                        .height_cm = 5,
                        .data = {{"curve", {{"x", {1, 2.385, 4}}, {"y", {10, 20, 1000}}}},
                                 {"dots", {{"x", {2}}, {"y", {30}}}}}};
    write_figure(folder / "generated/figures/apples", "apples", figure);
    folder.write("figures/style.gp", "set style line 1 lw 2\n");
    folder.write("figures/apples.gp", script);
    draw_figures(folder / "generated", folder / "figures", {{"apples", "fruit.cpp:3"}});
  }
  std::vector<PlottedPanel> panels() const {
    return plotted_panels(folder / "generated/figures/apples", "apples", folder / "scratch");
  }

  TemporaryFolder folder;
};

const std::string axes =
    "set lmargin at screen 0.25\nset rmargin at screen 0.75\nset bmargin at screen 0.2\n"
    "set tmargin at screen 0.9\nset xrange [0:5]\nset yrange [1:10000]\n";

}  // namespace

BOOST_AUTO_TEST_CASE(frame_axes_and_curves_are_what_gnuplot_drew) {
  const auto panels = Drawn(axes +
                            "set logscale y\nset xlabel '$\\theta$ \"(m)\"'\nset ylabel 'price'\n"
                            "plot curve using \"x\":\"y\" with lines title 'apples', \\\n"
                            "     dots using \"x\":(10 * column(\"y\")) with points notitle\n")
                          .panels();

  BOOST_TEST_REQUIRE(panels.size() == 1U);
  const PlottedPanel& panel = panels[0];
  BOOST_TEST(std::abs(panel.left - 0.25) < 0.002);
  BOOST_TEST(std::abs(panel.right - 0.75) < 0.002);
  BOOST_TEST(std::abs(panel.bottom - 0.2) < 0.004);
  BOOST_TEST(std::abs(panel.top - 0.9) < 0.004);
  BOOST_TEST(panel.x.label == "$\\theta$ \"(m)\"");
  BOOST_TEST(panel.y.label == "price");
  BOOST_TEST(panel.x.at_end == 5);
  BOOST_TEST(panel.y.at_end == 10000);
  BOOST_TEST(!panel.x.is_logarithmic);
  BOOST_TEST(panel.y.is_logarithmic);
  BOOST_TEST_REQUIRE(panel.curves.size() == 2U);
  BOOST_TEST(panel.curves[0].title == "apples");
  BOOST_TEST((panel.curves[0].points == Points{{1, 10}, {2.385, 20}, {4, 1000}}));
  BOOST_TEST(panel.curves[1].title == "");  // notitle
  BOOST_TEST((panel.curves[1].points == Points{{2, 300}}));
}

BOOST_AUTO_TEST_CASE(each_panel_of_a_page_has_its_own_frame_and_curves) {
  const auto panels = Drawn(
                          "set multiplot layout 1,2 \\\n  margins 0.1,0.9,0.2,0.9 spacing 0.1\n"
                          "do for [i = 1:2] {\n  set format x (i == 1 ? '$%g$' : '')\n"
                          "  plot curve using (i * column(\"x\")):\"y\" with lines\n}\n"
                          "unset multiplot\n")
                          .panels();

  BOOST_TEST_REQUIRE(panels.size() == 2U);
  BOOST_TEST(panels[0].right < panels[1].left);
  BOOST_TEST_REQUIRE(panels[1].curves.size() == 1U);
  BOOST_TEST(panels[1].curves[0].title == "");  // gnuplot's own
  BOOST_TEST((panels[1].curves[0].points == Points{{2, 10}, {4.77, 20}, {8, 1000}}));
}

BOOST_AUTO_TEST_CASE(points_outside_the_frame_are_left_out) {
  const auto panels =
      Drawn("set yrange [0:100]\nplot curve using \"x\":\"y\" with points\n").panels();

  BOOST_TEST_REQUIRE(panels.size() == 1U);
  BOOST_TEST((panels[0].curves[0].points == Points{{1, 10}, {2.385, 20}}));
}

BOOST_AUTO_TEST_CASE(a_reversed_axis_starts_at_its_greater_end) {
  const auto panels =
      Drawn("set yrange [100:0]\nplot curve using \"x\":\"y\" with points\n").panels();

  BOOST_TEST_REQUIRE(panels.size() == 1U);
  BOOST_TEST(panels[0].y.at_start == 100);
  BOOST_TEST(panels[0].y.at_end == 0);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_pointed_at_has_no_panels) {
  const std::string surface = "set view map\nsplot curve using \"x\":\"y\":\"y\" with points\n";
  BOOST_TEST(Drawn(surface).panels().empty());
  BOOST_TEST(Drawn("if (1) { plot curve using \"x\":\"y\" with points }\n").panels().empty());
  BOOST_TEST(Drawn("plot curve using \"x\":\"y\" with points, dots using \"x\":\"y\" axes x1y2\n")
                 .panels()
                 .empty());
}

BOOST_AUTO_TEST_CASE(a_plot_over_several_lines_is_told_after_its_last_line) {
  const std::string script = telling_axes("plot a, \\\n  b\nset key\n");

  BOOST_TEST(script.starts_with("plot a, \\\n  b\nprint sprintf('literate-frame"));
  BOOST_TEST(script.ends_with("show logscale\nset key\n"));
}

BOOST_AUTO_TEST_CASE(points_that_a_range_leaves_out_are_counted) {
  const auto n_outside = [](const std::string& range) {
    const Drawn drawn(range + "plot curve using \"x\":\"y\" with lines, dots using \"x\":\"y\"\n");
    return n_points_outside(drawn.folder / "generated/figures/apples", "apples",
                            drawn.folder / "scratch");
  };

  BOOST_TEST(n_outside("") == 0U);
  BOOST_TEST(n_outside("set yrange [10:1000]\n") == 0U);
  BOOST_TEST(n_outside("set yrange [15:999]\n") == 2U);
  BOOST_TEST(n_outside("set xrange [2.1:*]\n") == 2U);
}

BOOST_AUTO_TEST_CASE(data_that_the_script_does_not_name_are_told) {
  const auto unread = [](const std::string& script) {
    const Drawn drawn(script);
    return unread_blocks(drawn.folder / "generated/figures/apples");
  };

  BOOST_TEST(unread("plot curve using \"x\":\"y\", dots using \"x\":\"y\"\n").empty());
  BOOST_TEST(unread("plot value('do' . 'ts') using \"x\":\"y\"\n").empty());
  BOOST_TEST(unread("# dots\nplot curve using \"x\":\"y\" # and no other\n") ==
                 std::vector<std::string>{"dots"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(points_that_a_logarithmic_axis_cannot_show_are_counted) {
  const Drawn drawn(
      "set logscale y\nplot curve using \"x\":(column(\"y\") - 20) with points, \\\n"
      "  dots using \"x\":(sqrt(-1)) with points\n");
  BOOST_TEST(n_points_outside(drawn.folder / "generated/figures/apples", "apples",
                              drawn.folder / "scratch") == 2U);
}

BOOST_AUTO_TEST_CASE(points_of_a_function_are_none_that_were_registered) {
  const auto n_outside = [](const std::string& plot) {
    const Drawn drawn("set xrange [0:5]\nset yrange [15:999]\n" + plot + "\n");
    return n_points_outside(drawn.folder / "generated/figures/apples", "apples",
                            drawn.folder / "scratch");
  };

  BOOST_TEST(n_outside("plot 10 * x with lines, curve using \"x\":\"y\" with points") == 2U);
  BOOST_TEST(n_outside("set samples 3\nplot curve using \"x\":\"y\" with points, 10 * x") == 2U);
  BOOST_TEST(n_outside("plot '+' using 1:(10 * $1) with lines") == 0U);
}

BOOST_AUTO_TEST_SUITE_END()

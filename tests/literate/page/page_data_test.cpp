// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page_data.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "literate/document/document.hpp"
#include "literate/figures/draw.hpp"
#include "message_of.hpp"
#include "system/error.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(page_data_test)

using namespace literate;
using nlohmann::json;

namespace {

const std::string script =
    "set xrange [0:4]\nset yrange [0:50]\nset xlabel '$x$ (m)'\n"
    "plot points using \"x\":\"y\" with lines title 'a curve'\n";

/// What `compute` and `draw` leave behind of a small document.
struct Paper {
  Paper() {
    Document document;
    document.value("length", Value({2.385, 0.001}, significant(3), "mm"));
    document.value("name", Value::text("a </script> of <!-- text"));
    Table table("lengths", {Column("$x$", integer()).exact()});
    table.add_row({7});
    document.table(std::move(table));
    document.figure("curve", {.width_cm = 4,
                              .height_cm = 3,
                              .data = {{"points", {{"x", {1, 2, 4}}, {"y", {10, 20, 40}}}},
                                       {"band", {{"y", {3}}}}}});
    document.write(generated());
    folder.write("figures/curve.gp", script);
    folder.write("figures/style.gp", "# style\n");
    draw_figures(generated(), folder / "figures", {{"curve", "x.cpp:1"}});
  }
  std::filesystem::path generated() const { return folder / "generated"; }
  std::string text() const { return page_data(generated(), folder / "kept"); }
  json data() const { return json::parse(text()); }

  TemporaryFolder folder;
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_value_has_its_number_with_the_error_and_the_unit) {
  const json values = Paper().data().at("values");

  BOOST_TEST(values.at("length").at("printed") == "2.38 mm");
  BOOST_TEST(values.at("length").at("number") == 2.385);
  BOOST_TEST(values.at("length").at("abs_error") == 0.001);
  BOOST_TEST(values.at("length").at("unit") == "mm");
  BOOST_TEST(!values.at("name").contains("number"));
}

BOOST_AUTO_TEST_CASE(figures_and_tables_bring_the_bytes_of_their_data_and_the_script) {
  const json data = Paper().data();

  const json& figure = data.at("figures").at("curve");
  BOOST_TEST(figure.at("data").at(0).at("name") == "curve-band.csv");
  BOOST_TEST(figure.at("data").at(1).at("name") == "curve-points.csv");
  BOOST_TEST(figure.at("data").at(1).at("text") == "x,y\n1,10\n2,20\n4,40\n");
  BOOST_TEST(figure.at("script").at("name") == "curve.gp");
  BOOST_TEST(figure.at("script").at("text") == script);
  BOOST_TEST(data.at("tables").at("lengths").at("data").at(0).at("text") == "x\n7\n");
  BOOST_TEST(data.at("style").at("text") == "# style\n");
}

BOOST_AUTO_TEST_CASE(a_figure_tells_what_its_axes_and_curves_show) {
  const json panels = Paper().data().at("figures").at("curve").at("panels");

  BOOST_TEST_REQUIRE(panels.size() == 1U);
  BOOST_TEST(panels.at(0).at("x").at("label") == "x (m)");
  BOOST_TEST(panels.at(0).at("y").at("end") == 50);
  BOOST_TEST(panels.at(0).at("curves").at(0).at("title") == "a curve");
  BOOST_TEST(panels.at(0).at("curves").at(0).at("points") == json({1, 10, 2, 20, 4, 40}));
}

BOOST_AUTO_TEST_CASE(gnuplot_is_asked_again_only_for_a_figure_that_is_drawn_from_something_else) {
  const Paper paper;
  const json before = paper.data();
  const auto kept = paper.folder / "kept/curve.json";
  const auto file = sys::read_file(kept);
  sys::write_file_atomically(kept, file.substr(0, file.find('\n') + 1) + "[\"kept\"]");
  BOOST_TEST(paper.data().at("figures").at("curve").at("panels").at(0) == "kept");

  paper.folder.write("figures/curve.gp", script + "# another\n");
  draw_figures(paper.generated(), paper.folder / "figures", {{"curve", "x.cpp:1"}});

  BOOST_TEST(paper.data().at("figures").at("curve").at("panels") ==
             before.at("figures").at("curve").at("panels"));
}

BOOST_AUTO_TEST_CASE(no_text_ends_the_script_element_that_the_data_stand_in) {
  const Paper paper;

  BOOST_TEST(paper.text().find('<') == std::string::npos);
  BOOST_TEST(paper.data().at("values").at("name").at("printed") == "a </script> of <!-- text");
}

BOOST_AUTO_TEST_CASE(the_same_document_gives_the_same_bytes) {
  BOOST_TEST(Paper().text() == Paper().text());
}

BOOST_AUTO_TEST_CASE(a_file_that_is_missing_is_named) {
  const Paper paper;
  std::filesystem::remove(paper.generated() / "figures/curve/script.gp");

  const std::string message = message_of<sys::OutputError>([&] { paper.text(); });

  BOOST_TEST(message.find("script.gp") != std::string::npos, message);
}

BOOST_AUTO_TEST_CASE(names_that_another_version_wrote_are_refused) {
  const Paper paper;
  paper.folder.write("generated/names.json", "{}");

  const std::string message = message_of<sys::OutputError>([&] { paper.text(); });

  BOOST_TEST(message.find("names.json") != std::string::npos, message);
}

BOOST_AUTO_TEST_SUITE_END()

// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page.hpp"

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

BOOST_AUTO_TEST_CASE(values_figures_and_tables_bring_their_numbers_bytes_and_curves) {
  const json expected = json::parse(R"json({
    "values": {"length": {"printed": "2.38 mm", "number": 2.385, "abs_error": 0.001, "unit": "mm"},
               "name": {"printed": "a </script> of <!-- text"}},
    "tables": {"lengths": {"data": [{"name": "lengths.csv", "text": "x\n7\n"}]}},
    "figures": {"curve": {
      "data": [{"name": "curve-band.csv", "text": "y\n3\n"},
               {"name": "curve-points.csv", "text": "x,y\n1,10\n2,20\n4,40\n"}],
      "script": {"name": "curve.gp"},
      "panels": [{"x": {"label": "x (m)"}, "y": {"end": 50},
                  "curves": [{"title": "a curve", "points": [1, 10, 2, 20, 4, 40]}]
}]
}
}
, "style" : {
  "name" : "style.gp", "text" : "# style\n"
}
})json");
  const Paper paper;

  const json data = paper.data(), parts = expected.flatten();
  BOOST_TEST(data.at("figures").at("curve").at("script").at("text") == script);
  BOOST_TEST(!data.at("values").at("name").contains("number"));
  for (const auto& [place, value] : parts.items()) {
    BOOST_TEST(data.at(json::json_pointer(place)) == value, place);
  }
  BOOST_TEST(data.at("figures").at("curve").at("panels").size() == 1U);
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

BOOST_AUTO_TEST_CASE(the_same_document_gives_the_same_bytes_and_none_ends_its_script_element) {
  BOOST_TEST(Paper().text() == Paper().text());
  BOOST_TEST(Paper().text().find('<') == std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_file_that_is_missing_or_of_another_version_is_named) {
  const Paper paper;
  std::filesystem::remove(paper.generated() / "figures/curve/script.gp");
  const std::string missing = message_of<sys::OutputError>([&] { paper.text(); });
  paper.folder.write("generated/names.json", "{}");
  const std::string other = message_of<sys::OutputError>([&] { paper.text(); });

  BOOST_TEST(missing.find("script.gp") != std::string::npos, missing);
  BOOST_TEST(other.find("names.json") != std::string::npos, other);
}

BOOST_AUTO_TEST_SUITE_END()

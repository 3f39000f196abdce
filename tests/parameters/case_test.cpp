// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/case.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "papers_case.hpp"

BOOST_AUTO_TEST_SUITE(case_test)

using parameters::Case;
using parameters::CaseFile;
using parameters::read_case;

namespace {

template <class Read = Case (*)(const std::filesystem::path&)>
auto read(const std::string& text, Read reader = &read_case) {
  const TemporaryFolder folder;
  return reader(folder.write("case.toml", text));
}

// The text is rejected in one line with the expected message.
template <class Read = Case (*)(const std::filesystem::path&)>
void check_refused(const std::string& text, const std::string& says, Read reader = &read_case) {
  BOOST_CHECK_EXCEPTION(read(text, reader), config::Error, [&](const config::Error& e) {
    const std::string what = e.what();
    BOOST_TEST_MESSAGE(what);
    return what.find(says) != what.npos && what.find('\n') == what.npos;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_papers_case_has_the_numbers_of_the_paper) {
  const Case c = case_of(papers_text());

  BOOST_TEST(c.units.name == "in-lbf");
  BOOST_TEST(c.half_space.material.young() == 30e6);
  BOOST_TEST(c.half_space.material.poisson() == 0.3);
  BOOST_TEST(c.half_space.load.line_load() == 10);
  BOOST_TEST(c.half_space.datum == 10);
  BOOST_TEST(c.half_space.points.size() == 11U);
  BOOST_TEST(c.half_space.points[2] == 0.01);
  BOOST_TEST(c.half_space.farthest_point() == 0.05);
  BOOST_TEST(c.contact.line_load == 2500);
  BOOST_TEST(c.point_contact.value().load == 100);
  BOOST_TEST(c.block.value().rectangle.width() == 2);
  BOOST_TEST(c.printed.has_value());
}

BOOST_AUTO_TEST_CASE(a_reader_takes_the_tables_that_it_needs) {
  const auto contact_alone =
      "units = \"in-lbf\"\n" + papers_text().substr(papers_text().find("[contact]"),
                                                    papers_text().find("\n[point_contact]") -
                                                        papers_text().find("[contact]"));
  const auto contact = [](const auto& file) { return CaseFile(file).contact(); };
  BOOST_TEST(read(contact_alone, contact).line_load == 2500);
  check_refused(contact_alone + "\nnods = 3", "nods: unknown key", contact);
  check_refused(contact_alone, "half_space: missing",
                [](const auto& file) { return CaseFile(file).half_space(); });

  BOOST_TEST(
      !read(without(papers_text(), "\n[point_contact]", "\n[block]")).point_contact.has_value());
  BOOST_TEST(!read(papers_text().substr(0, papers_text().find("\n[printed]"))).printed.has_value());
  BOOST_TEST(read(with(papers_text(), "[printed.tri_dist]", "[printed.other]"))
                 .printed.value()
                 .has("other"));
}

BOOST_AUTO_TEST_CASE(radii_points_and_units_may_differ) {
  const auto radius2 = [](const std::string& other) {
    return read(with(papers_text(), "radius = {value = 3, unit = \"in\"}", "radius = " + other));
  };
  BOOST_TEST(radius2("\"plane\"").contact.cylinders.relative_curvature() == 1);
  BOOST_TEST(radius2("{value = -2, unit = \"in\"}").contact.cylinders.relative_curvature() == 0.5);
  const auto left = with(papers_text(), "first = {value = 0,", "first = {value = -0.05,");
  BOOST_TEST(read(left).half_space.farthest_point() == 0.05);
  const auto ksi =
      with(papers_text(), "{value = 30e6, unit = \"psi\"}", "{value = 30e3, unit = \"ksi\"}");
  BOOST_TEST(read(ksi).half_space.material.young() == 30e6);
}

BOOST_AUTO_TEST_CASE(numbers_out_of_range_are_rejected_by_key) {
  const std::string half_width = "half_space.load.half_width";
  const std::string refusals[][3] = {
      {"title = \"Ruggiero (2001)\"", "title = \"  \"", ":6:9: title: must not be empty"},
      {"units = \"in-lbf\"  #", "units = \"ft-lbf\"  #", "units: unknown unit system"},
      {"unit = \"psi\"", "unit = \"in\"", "half_space.material.young.unit"},
      {"value = 30e6", "value = -30e6",
       "half_space.material.young: -30000000 psi: must be greater"},
      {"value = 30e6", "value = 0", "half_space.material.young"},
      {"poisson = 0.30", "poisson = 0.5", "half_space.material.poisson"},
      {"poisson = 0.30", "poisson = 0.30\npoison = 1", "half_space.material.poison: unknown"},
      {"poisson = 0.30", "", "half_space.material.poisson: missing"},
      {"poisson = 0.30", "poisson = \"0.30\"", "must be a number"},
      {"peak_pressure = {value = 1000", "peak_pressure = {value = 0", "load.peak_pressure"},
      {"peak_pressure = {value = 1000", "peak_pressure = {value = 1e51", "load.peak_pressure"},
      {"half_width = {value = 0.010", "half_width = {value = -0.01", "load.half_width"},
      {"datum = {value = 10", "datum = {value = -10", "half_space.datum"},
      {"datum = {value = 10,", "datum = {value = 1000001,", half_width},
      {"value = 10, unit", "value = nan, unit", "half_space.datum.value"},
      {"step = {value = 0.005", "step = {value = 0", "points.step"},
      {"step = {value = 0.005", "step = {value = 200000", half_width},
      {"first = {value = 0,", "first = {value = -1e60,", "points.first"},
      {"count = 11", "count = 1", "points.count"},
      {"count = 11", "count = 1001", "points.count: 1001: must be from 2 to 1000"},
      {"value = 2500", "value = 1e-300", "contact.load"},
      {"datum = {value = 1,", "datum = {value = 0.01,", "contact.load, nodes, body1"},
      {"nodes = 91", "nodes = 9", "contact.nodes: 9: must be from 10 to 16777216"},
      {"radius = {value = 1,", "radius = {value = 0,", "contact.body1.radius"},
      {"radius = {value = 3,", "radius = {value = 1e60,", "contact.body2.radius"},
      {"radius = {value = 3,", "radius = {value = -0.5,",
       "contact.body2.radius: 1/radius1 + 1/radius2 = -1: must be greater than 0: at most one "
       "plane"},
      {"load = {value = 100, unit = \"lbf\"}", "load = {value = -100, unit = \"lbf\"}",
       "point_contact.load: -100 lbf: must be greater than 0"},
      {"order = 7", "order = 11", "block.order"},
      {"order = 7", "order = 4294967303", "block.order"},  // 2³² + 7
      {"refine = 2", "refine = 7", "block.refine: 7: must be from 1 to 4"},
      {"sides = \"clamped\"", "sides = \"held\"", "must be clamped, roller or free"},
      {"width = {value = 2,", "width = {value = 20.1,", half_width},
      {"height = {value = 1,", "height = {value = 20.1,", half_width},
      {"width = {value = 2,", "width = {value = 0.02,",
       "block.width: 0.02 in: must be greater than 0.02 in, twice " + half_width},
      {"width = {value = 2,", "width = {value = 0.09,",
       "0.09 in: must be at least 0.1 in, twice the farthest of half_space.points"},
  };
  for (const auto& [before, after, says] : refusals) {
    BOOST_TEST_CONTEXT(after) {
      check_refused(with(papers_text(), before, after), says);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

// SPDX-License-Identifier: GPL-3.0-or-later
// Flags are parsed as the program parses them: by a command that only has those of a load.
#include "app/load_choices.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elasticity/surface_quadrature.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(load_choices_test)

using Flags = std::vector<std::string>;

namespace {

const elasticity::Material steel(207e3, 0.29);
constexpr double datum = 7.7;

// What the last command line asked for, or why it was refused.
std::optional<elasticity::KnownLoad> chosen;
std::string refusal;

void add_loads(CLI::App& program, command_line::ExitCode& exit_code) {
  command_line::add_command(program, "c", "A load", exit_code, [](CLI::App& command) {
    const auto shape = std::make_shared<app::ChoiceOption>(
        command, "--shape", "triangular", "Shape", app::choices_of(app::load_choices()));
    return [shape] {
      try {
        shape->refuse_flags_of_others();
        chosen = app::load_choices()[shape->row()].make(*shape, app::numbers_of(*shape, {}));
      } catch (const sys::Error& error) {
        refusal = error.what();
      }
      return command_line::ExitCode::success;
    };
  });
}

void parse(Flags flags) {
  chosen.reset();
  refusal.clear();
  flags.insert(flags.begin(), {"halfspace", "c", "--shape"});
  std::vector<char*> arguments;
  for (std::string& flag : flags) arguments.push_back(flag.data());
  command_line::run_program({.name = "test", .description = "", .version = ""}, {add_loads},
                            static_cast<int>(arguments.size()), arguments.data());
}

const Flags peak{"--peak-pressure", "2.385"};
const Flags width{"--half-width", "0.75"};

Flags operator+(Flags flags, const Flags& more) {
  flags.insert(flags.end(), more.begin(), more.end());
  return flags;
}

elasticity::KnownLoad load_of(const Flags& flags) {
  parse(flags);
  BOOST_TEST_REQUIRE(chosen.has_value(), refusal);
  return *chosen;
}

void check_refused(const Flags& flags, const std::string& reason) {
  parse(flags);
  BOOST_TEST(!chosen.has_value());
  BOOST_TEST(refusal.find(reason) != std::string::npos, refusal);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_shape_of_the_table_can_be_asked_for) {
  for (const elasticity::LoadShape& shape : elasticity::load_shapes()) {
    Flags flags{shape.parameter.empty() ? shape.name : shape.name + ":0.6"};
    for (const std::string& number : shape.numbers) flags.insert(flags.end(), {"--" + number, "2"});
    const elasticity::Load load = load_of(flags).load;
    BOOST_TEST(elasticity::normal_resultant(load) > 0, shape.name);
  }
}

BOOST_AUTO_TEST_CASE(a_parameter_is_what_follows_the_colon) {
  const elasticity::Load load = load_of(Flags{"linear:0.608"} + peak + width).load;
  BOOST_CHECK_CLOSE(load.normal(0.375), 2.385 * (1 + 0.608) / 2, 1e-12);
}

BOOST_AUTO_TEST_CASE(the_formula_of_a_parabola_has_the_integrals_of_the_parabola) {
  const auto formula = load_of(Flags{"expression:p0*(1-(x/a)^2)"} + peak + width);
  const auto parabola = load_of(Flags{"parabolic"} + peak + width).surface(steel, datum);
  BOOST_TEST(!formula.surface);
  const elasticity::SurfaceQuadrature surface(steel, formula.load, datum);
  const double unit = steel.integral_compliance() * 2.385;
  for (const double x : {-2.0, -0.75, -0.3, 0.0, 0.5, 0.75, 1.1}) {
    const auto check = [&](const numerics::Estimate& estimate, double exact) {
      BOOST_TEST(std::abs(estimate.value - exact) <= estimate.abs_error + 1e-14 * unit,
                 "x = " << x);
    };
    check(surface.normal_gradient(x), parabola.normal_gradient(x));
    check(surface.normal_displacement(x), parabola.normal_displacement(x));
  }
}

BOOST_AUTO_TEST_CASE(an_expression_is_split_at_its_kinks) {
  const Flags expression = Flags{"expression:p0*max(0, 1-abs(x)/0.3)"} + peak + width;
  const auto split = load_of(expression + Flags{"--kinks", "-0.3,0.3"});

  BOOST_TEST(split.load.normal.pieces().size() == 4U);
  check_refused(expression + Flags{"--kinks", "0.75"}, "--kinks: 0.75 does not lie under the load");
}

BOOST_AUTO_TEST_CASE(what_is_missing_or_wrong_is_named) {
  check_refused(Flags{"parabolic"} + width, "--peak-pressure is missing");
  check_refused({"expression:1"}, "--half-width is missing");
  check_refused(Flags{"expression:p0*x"} + width, "column 1");
  check_refused(Flags{"linear:much"} + peak + width, "linear:EDGE_FRACTION: \"much\"");
  check_refused(Flags{"linear:"} + peak + width, "linear:EDGE_FRACTION");
  check_refused(Flags{"concentrated"} + width, "--half-width has no meaning for --shape conc");
  check_refused({"square"}, "--shape = square: must be triangular, uniform, ");
  check_refused({"square"}, "concentrated, file:PATH or expression:FORMULA");
}

BOOST_AUTO_TEST_CASE(files_that_are_no_load_are_refused_by_file_and_line) {
  const TemporaryFolder folder;
  const auto check = [&](const std::string& text, const std::string& reason) {
    const std::string file = folder.write("load.csv", text).string();
    check_refused({"file:" + file}, file + reason);
  };
  check("x,pressure\n0,1\n1,2\n0.5,1\n", ":4: x = 0.5: must be greater than the one before, 1");
  check("x,pressure\n0,1\n", ": holds 1 points, 2 or more are needed");
  check("x,pressure\n0,1\n1,high\n", ":3: pressure");
  check("x,p\n0,1\n1,2\n", ":1: the heading must be x,pressure");
}

BOOST_AUTO_TEST_SUITE_END()

// SPDX-License-Identifier: GPL-3.0-or-later
// Flags are parsed as the program parses them: by a command that only has a point contact's
// options.
#include "app/point_contact_options.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "system/error.hpp"
#include "temporary_folder.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(point_contact_options_test)

using app::PointContactInput;
using app::PointContactOptions;
using tolerance::relative_difference;
using Flags = std::vector<std::string>;

namespace {

const std::string papers_case = HALFSPACE_SOURCE_DIR "/report/ruggiero2001.toml";

// What the last command line asked for, or why it was refused.
std::optional<PointContactInput> input;
std::string refusal;

void add_point_contact(CLI::App& program, command_line::ExitCode& exit_code) {
  command_line::add_command(program, "c", "A contact", exit_code, [](CLI::App& command) {
    const auto options = std::make_shared<PointContactOptions>(command);
    return [options] {
      try {
        std::optional<parameters::Case> from_file;
        if (!options->case_file().empty()) {
          from_file = parameters::read_case(options->case_file());
        }
        input.emplace(options->read(from_file));
      } catch (const sys::Error& error) {
        refusal = error.what();
      }
      return command_line::ExitCode::success;
    };
  });
}

void parse(Flags flags) {
  input.reset();
  refusal.clear();
  flags.insert(flags.begin(), {"halfspace", "c"});
  std::vector<char*> arguments;
  for (std::string& flag : flags) arguments.push_back(flag.data());
  command_line::run_program({.name = "test", .description = "", .version = ""}, {add_point_contact},
                            static_cast<int>(arguments.size()), arguments.data());
}

PointContactInput read(const Flags& flags) {
  parse(flags);
  BOOST_TEST_REQUIRE(input.has_value(), refusal);
  return *input;
}

void check_refused(const Flags& flags, const std::string& reason) {
  parse(flags);
  BOOST_TEST_CONTEXT(reason) {
    BOOST_TEST(!input.has_value());
    BOOST_TEST(refusal.find(reason) != std::string::npos, refusal);
  }
}

Flags operator+(Flags flags, const Flags& more) {
  flags.insert(flags.end(), more.begin(), more.end());
  return flags;
}

const Flags materials{"--young1", "30e6", "--poisson1", "0.3",
                      "--young2", "10e6", "--poisson2", "0.25"};
const Flags loaded = materials + Flags{"--load", "2.385"};
const Flags spheres = loaded + Flags{"--radius1", "1.7", "--radius2", "plane"};
// 1/E* = 0.91/30e6 + 0.9375/10e6
const double modulus = 1 / (0.91 / 30e6 + 0.9375 / 10e6);

}  // namespace

BOOST_AUTO_TEST_CASE(a_sphere_on_a_plane_has_hertz_for_its_closed_form_and_fills_nine_tenths) {
  const PointContactInput contact = read(spheres);

  // a³ = 3PR/(4E*), Johnson (4.22)
  const double radius = std::cbrt(3 * 2.385 * 1.7 / (4 * modulus));
  BOOST_TEST(relative_difference(contact.problem.contact_modulus, modulus) < 1e-14);
  BOOST_TEST_REQUIRE(contact.closed_form.has_value());
  BOOST_TEST(contact.closed_form->name == "hertz");
  BOOST_TEST(relative_difference(contact.closed_form->half_width_x, radius) < 1e-14);
  BOOST_TEST(contact.is_of_revolution);
  BOOST_TEST(contact.least_radius == 1.7);
  const point_contact::Grid& grid = contact.problem.grid;
  BOOST_TEST(grid.n1 == 256);
  BOOST_TEST(grid.is_staggered);
  BOOST_TEST(relative_difference(256 * grid.lattice.first.x(), 2 * radius / 0.9) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_nodes_fill_the_square_that_is_asked_for) {
  const PointContactInput hexagonal = read(spheres + Flags{"--nodes", "90", "--domain", "0.77"});
  const PointContactInput square =
      read(spheres + Flags{"--nodes", "90", "--domain", "0.77", "--grid", "square"});
  const PointContactInput flat = read(spheres + Flags{"--nodes", "90", "--domain", "0.77",
                                                      "--domain-y", "0.11", "--grid", "square"});

  BOOST_TEST(hexagonal.problem.grid.n1 == 90);
  BOOST_TEST(hexagonal.problem.grid.n2 == 104);  // 90 · 2/√3 = 103.9
  BOOST_TEST(square.problem.grid.n2 == 90);
  BOOST_TEST(relative_difference(90 * square.problem.grid.lattice.second.y(), 0.77) < 1e-14);
  BOOST_TEST(relative_difference(90 * flat.problem.grid.lattice.second.y(), 0.11) < 1e-14);
  BOOST_TEST(relative_difference(90 * flat.problem.grid.lattice.first.x(), 0.77) < 1e-14);
}

BOOST_AUTO_TEST_CASE(crossed_cylinders_of_one_radius_are_a_sphere_on_a_plane) {
  const PointContactInput crossed =
      read(loaded + Flags{"--radius1x", "1.7", "--radius1y", "plane", "--radius2x", "1.7",
                          "--radius2y", "plane", "--angle", "90"});
  const PointContactInput sphere = read(spheres);

  BOOST_TEST(crossed.is_of_revolution);
  BOOST_TEST(relative_difference(crossed.closed_form->half_width_x,
                                 sphere.closed_form->half_width_x) < 1e-13);
}

BOOST_AUTO_TEST_CASE(an_ellipse_gets_a_domain_of_its_shape_along_its_axes) {
  const PointContactInput contact =
      read(loaded + Flags{"--radius1x", "0.3", "--radius1y", "5", "--radius2", "plane"});

  // longest where the radius is greatest: along the y axis of body 1
  BOOST_TEST(std::abs(std::abs(contact.curvatures->angle) - 1.5707963267948966) < 1e-12);
  const auto& exact = contact.closed_form.value();
  BOOST_TEST(exact.half_width_x > 3 * exact.half_width_y);
  const point_contact::Grid& grid = contact.problem.grid;
  BOOST_TEST(relative_difference(grid.lattice.first.x() * 256, 2 * exact.half_width_x / 0.9) <
             1e-12);
  BOOST_TEST(relative_difference(grid.lattice.second.y() / grid.lattice.first.x(),
                                 std::sqrt(0.75) * exact.half_width_y / exact.half_width_x) <
             1e-12);
}

BOOST_AUTO_TEST_CASE(under_an_approach_the_closed_form_is_that_of_the_load_it_takes) {
  for (const Flags& body : {Flags{"--radius1", "1.7", "--radius2", "plane"},
                            Flags{"--radius1x", "1.7", "--radius1y", "0.2", "--radius2", "plane"},
                            Flags{"--profile", "cone", "--slope", "0.01"},
                            Flags{"--profile", "flat-punch", "--flat", "0.3"},
                            Flags{"--profile", "power", "--power", "2", "--coefficient", "0.7"}}) {
    const auto under_load = read(loaded + body).closed_form.value();
    const auto back =
        read(materials + Flags{"--approach", fmt::format("{}", under_load.approach)} + body)
            .closed_form.value();
    BOOST_TEST_CONTEXT(under_load.name) {
      BOOST_TEST(relative_difference(back.load, 2.385) < 1e-12);
      BOOST_TEST(relative_difference(back.approach, under_load.approach) < 1e-12);
      BOOST_TEST(relative_difference(back.half_width_x, under_load.half_width_x) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_case_gives_materials_and_radii_and_flags_override_it) {
  const Flags from_case{"--case", papers_case, "--load", "2.385"};
  const PointContactInput as_given = read(from_case);
  const PointContactInput overridden = read(from_case + Flags{"--radius1", "7"});

  BOOST_TEST(as_given.closed_form->half_width_x != overridden.closed_form->half_width_x);
  BOOST_TEST(as_given.problem.contact_modulus == overridden.problem.contact_modulus);
}

BOOST_AUTO_TEST_CASE(heights_are_gaps_below_the_highest) {
  const TemporaryFolder folder;
  const std::string gaps =
      folder.write("gaps.csv", "3,2,3,4,5\n2,0,1,2,3\n3,2,3,4,5\n5,4,3,4,5\n").string();
  const std::string heights =
      folder.write("heights.csv", "4,5,4,3,2\n5,7,6,5,4\n4,5,4,3,2\n2,3,4,3,2\n").string();
  const Flags grid{"--spacing", "0.1", "--nodes", "8"};
  const PointContactInput one = read(loaded + grid + Flags{"--profile", "file:" + gaps});
  const PointContactInput other = read(loaded + grid + Flags{"--profile", "heights:" + heights});

  // five along x and four along y
  BOOST_TEST(one.problem.profile.half_sides().x() == 0.2);
  BOOST_TEST(relative_difference(one.problem.profile.half_sides().y(), 0.15) < 1e-14);
  BOOST_TEST(std::abs(one.problem.profile.gap({-0.1, -0.05})) < 1e-14);
  BOOST_TEST(relative_difference(one.problem.profile.gap({0.2, 0.15}), 5) < 1e-14);
  for (const double x : {-0.2, -0.1, 0.03, 0.17}) {
    BOOST_TEST(std::abs(one.problem.profile.gap({x, 0.02}) - other.problem.profile.gap({x, 0.02})) <
               1e-13);
  }
  BOOST_TEST(!one.closed_form.has_value());
}

BOOST_AUTO_TEST_CASE(what_is_missing_is_named) {
  check_refused(materials + Flags{"--radius1", "1", "--radius2", "1"}, "--load is missing");
  check_refused(loaded + Flags{"--radius1", "1"}, "--radius2 is missing");
  check_refused(loaded + Flags{"--radius1x", "1", "--radius2", "1"}, "--radius1y is missing");
  check_refused({"--load", "1", "--young1", "30e6"}, "--poisson1 is missing");
  check_refused(loaded + Flags{"--profile", "cone"}, "--slope is missing");
  check_refused(loaded + Flags{"--profile", "flat-punch"}, "--flat is missing");
  check_refused(loaded + Flags{"--profile", "power"}, "--power is missing");
  check_refused(loaded + Flags{"--profile", "file:none.csv"}, "--spacing is missing");
  check_refused(loaded + Flags{"--profile", "rounded-punch", "--flat", "1", "--edge-radius", "1"},
                "--domain is missing");
  check_refused(spheres + Flags{"--domain-y", "1"}, "--domain-y needs --domain");
}

BOOST_AUTO_TEST_CASE(flags_that_contradict_each_other_or_mean_nothing_are_refused) {
  check_refused(loaded + Flags{"--profile", "cone", "--slope", "0.1", "--radius1", "1"},
                "--radius1 has no meaning for --profile cone");
  check_refused(spheres + Flags{"--spacing", "1"}, "--spacing has no meaning for --profile sphere");
  check_refused(spheres + Flags{"--radius1x", "1"}, "--radius1 and --radius1x: give one");
  check_refused(spheres + Flags{"--approach", "1e-6"}, "--load and --approach: give one of them");
  check_refused(spheres + Flags{"--tangential-load", "0.1"}, "--tangential-load needs --friction");
  check_refused(spheres + Flags{"--element", "bilinear"}, "--element bilinear needs --grid square");
  check_refused(spheres + Flags{"--method", "matrix-inversion", "--tolerance", "1e-8"},
                "--tolerance has no meaning for --method matrix-inversion");
  check_refused(spheres + Flags{"--threads", "0"}, "--threads = 0: must be from 1 to 64");
  check_refused(spheres + Flags{"--nodes", "7"}, "--nodes = 7: must be 8 or more");
  check_refused(loaded + Flags{"--profile", "wedge"}, "--profile = wedge: must be sphere, cone");
  check_refused(loaded + Flags{"--profile", "power", "--coefficient", "1", "--power", "0"},
                "--power = 0: must be from 1 to");
  check_refused(materials + Flags{"--radius1", "1", "--radius2", "1", "--approach", "-1"},
                "approach = -1: must be greater than 0");
}

BOOST_AUTO_TEST_CASE(bodies_that_do_not_touch_at_a_point_are_refused) {
  check_refused(loaded + Flags{"--radius1", "1", "--radius2", "-1"}, "sum of the curvatures = 0");
  check_refused(loaded + Flags{"--radius1", "1", "--radius2", "-0.5"},
                "sum of the curvatures = -2");
  check_refused(loaded + Flags{"--radius1x", "1", "--radius1y", "plane", "--radius2x", "1",
                               "--radius2y", "plane"},
                "least relative curvature = 0");
  check_refused(loaded + Flags{"--radius1", "0", "--radius2", "1"}, "radius1 = 0");
}

BOOST_AUTO_TEST_CASE(nodes_without_memory_are_refused_with_their_need) {
  for (const char* n : {"100000", "99999999999", "4000000000000000000"}) {
    check_refused(spheres + Flags{"--nodes", n}, "GB of memory");
  }
}

BOOST_AUTO_TEST_SUITE_END()

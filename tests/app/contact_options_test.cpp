// SPDX-License-Identifier: GPL-3.0-or-later
// Flags are parsed as the program parses them: by a command that only has a contact's options.
#include "app/contact_options.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "command_line/options.hpp"
#include "system/error.hpp"
#include "tolerances.hpp"

BOOST_AUTO_TEST_SUITE(contact_options_test)

using app::ContactInput;
using app::ContactOptions;
using tolerance::relative_difference;
using Flags = std::vector<std::string>;

namespace {

const std::string papers_case = HALFSPACE_SOURCE_DIR "/report/ruggiero2001.toml";

const Flags materials{"--young1", "30e6", "--poisson1", "0.3",
                      "--young2", "10e6", "--poisson2", "0.25"};

// What the last command line asked for, or why it was refused.
std::optional<ContactInput> input;
std::string refusal;

void add_contact(CLI::App& program, command_line::ExitCode& exit_code) {
  command_line::add_command(program, "contact", "A contact", exit_code, [](CLI::App& command) {
    const auto options = std::make_shared<ContactOptions>(command);
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
  flags.insert(flags.begin(), {"halfspace", "contact"});
  std::vector<char*> arguments;
  for (std::string& flag : flags) arguments.push_back(flag.data());
  command_line::run_program({.name = "test", .description = "", .version = ""}, {add_contact},
                            static_cast<int>(arguments.size()), arguments.data());
}

ContactInput read(const Flags& flags) {
  parse(flags);
  BOOST_TEST_REQUIRE(input.has_value(), refusal);
  return *input;
}

// With the materials and a number of nodes, which every contact needs.
Flags with_basics(const Flags& flags) {
  Flags all = materials;
  all.insert(all.end(), {"--nodes", "77"});
  all.insert(all.end(), flags.begin(), flags.end());
  return all;
}

void check_refused(const Flags& flags, const std::string& reason) {
  parse(flags);
  BOOST_TEST_CONTEXT(reason) {
    BOOST_TEST(!input.has_value());
    BOOST_TEST(refusal.find(reason) != std::string::npos, refusal);
  }
}

const Flags cylinders{"--radius1", "1.7", "--radius2", "plane"};
const Flags loaded_cylinders{"--radius1", "1.7", "--radius2", "plane", "--load", "2.385"};

Flags operator+(Flags flags, const Flags& more) {
  flags.insert(flags.end(), more.begin(), more.end());
  return flags;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_cylinder_on_a_plane_has_hertz_for_its_closed_form) {
  const ContactInput contact = read(with_basics(loaded_cylinders));

  // a² = 4PR/(πE*), Johnson (4.43), with 1/E* = 0.91/30e6 + 0.9375/10e6
  const double modulus = 1 / (0.91 / 30e6 + 0.9375 / 10e6);
  const double half_width = std::sqrt(4 * 2.385 * 1.7 / (std::numbers::pi * modulus));
  BOOST_TEST(relative_difference(contact.problem.contact_modulus, modulus) < 1e-14);
  BOOST_TEST_REQUIRE(contact.closed_form.has_value());
  BOOST_TEST(contact.closed_form->name == "hertz");
  BOOST_TEST(relative_difference(contact.closed_form->half_width, half_width) < 1e-14);
  BOOST_TEST(contact.problem.grid.n_nodes == 77);
}

BOOST_AUTO_TEST_CASE(flags_override_the_case_and_the_rest_is_its) {
  const ContactInput as_given = read({"--case", papers_case});
  const ContactInput overridden = read({"--case", papers_case, "--load", "2.385"});

  BOOST_TEST(as_given.line_load.value() != 2.385);
  BOOST_TEST(overridden.line_load.value() == 2.385);
  BOOST_TEST(overridden.problem.grid.n_nodes == as_given.problem.grid.n_nodes);
  BOOST_TEST(overridden.problem.contact_modulus == as_given.problem.contact_modulus);
}

BOOST_AUTO_TEST_CASE(up_to_a_thousand_nodes_are_inverted_and_more_are_for_fft) {
  const Flags contact = materials + loaded_cylinders;

  BOOST_TEST(read(contact + Flags{"--nodes", "1000"}).method == "matrix-inversion");
  BOOST_TEST(read(contact + Flags{"--nodes", "1001"}).method == "fft");
  BOOST_TEST(read(contact + Flags{"--nodes", "1001", "--method", "variational"}).method ==
             "variational");
}

BOOST_AUTO_TEST_CASE(the_nodes_fill_the_domain) {
  const ContactInput contact = read(with_basics(loaded_cylinders + Flags{"--domain", "0.77"}));
  const ContactInput one_sided =
      read(with_basics(loaded_cylinders + Flags{"--domain", "0.77", "--grid", "one-sided"}));

  BOOST_TEST(contact.problem.grid.n_nodes == 77);
  BOOST_TEST(one_sided.problem.grid.n_nodes == 77);
  BOOST_TEST(one_sided.problem.grid.spacing < 0.6 * contact.problem.grid.spacing);
}

BOOST_AUTO_TEST_CASE(other_profiles_have_closed_forms_of_their_own) {
  const Flags load{"--load", "2.385"};

  BOOST_TEST(
      read(with_basics(load + Flags{"--profile", "wedge", "--slope", "0.037"})).closed_form->name ==
      "wedge");
  BOOST_TEST(read(with_basics(load + Flags{"--profile", "rounded-punch", "--flat", "0.6",
                                           "--edge-radius", "1.7"}))
                 .closed_form->name == "rounded-punch");
  BOOST_TEST(
      read(with_basics(load + Flags{"--profile", "power", "--power", "3", "--coefficient", "0.57"}))
          .closed_form->name == "power");
}

BOOST_AUTO_TEST_CASE(an_approach_has_no_closed_form) {
  const ContactInput contact = read(
      with_basics(cylinders + Flags{"--approach", "1e-6", "--datum", "10", "--domain", "0.1"}));

  BOOST_TEST(!contact.line_load.has_value());
  BOOST_TEST(!contact.closed_form.has_value());
  BOOST_TEST(contact.approach.value() == 1e-6);
}

BOOST_AUTO_TEST_CASE(what_is_missing_is_named) {
  check_refused(materials + loaded_cylinders, "--nodes is missing");
  check_refused(with_basics(cylinders), "--load is missing");
  check_refused({"--nodes", "77", "--young1", "30e6"}, "--poisson1 is missing");
  check_refused(with_basics({"--load", "1", "--profile", "wedge"}), "--slope is missing");
  check_refused(with_basics({"--load", "1", "--profile", "power"}), "--power is missing");
  check_refused(with_basics(cylinders + Flags{"--approach", "1e-6"}), "--datum is missing");
  check_refused(with_basics(cylinders + Flags{"--approach", "1e-6", "--datum", "10"}),
                "--domain is missing");
}

BOOST_AUTO_TEST_CASE(flags_that_contradict_each_other_or_mean_nothing_are_refused) {
  check_refused(
      with_basics({"--load", "1", "--profile", "wedge", "--slope", "0.1", "--radius1", "1.7"}),
      "--radius1 has no meaning for --profile wedge");
  check_refused(with_basics({"--load", "1", "--profile", "wedge", "--slope", "0.1", "--flat", "2"}),
                "--flat has no meaning for --profile wedge");
  check_refused(with_basics(loaded_cylinders + Flags{"--power", "3"}),
                "--power has no meaning for --profile cylinder");
  check_refused(with_basics(loaded_cylinders + Flags{"--approach", "1e-6"}),
                "--load and --approach: give one of them");
  check_refused(with_basics(loaded_cylinders + Flags{"--tangential-load", "0.1"}),
                "--tangential-load needs --friction");
  check_refused(with_basics(loaded_cylinders + Flags{"--friction", "0.3", "--grid", "one-sided"}),
                "--friction needs --grid symmetric");
  check_refused(with_basics(loaded_cylinders + Flags{"--tolerance", "1e-8"}),
                "--tolerance has no meaning for --method matrix-inversion");
  check_refused(with_basics({"--load", "1", "--profile", "cone"}),
                "--profile = cone: must be cylinder, wedge, rounded-punch, power or file:PATH");
  check_refused(
      with_basics({"--load", "1", "--profile", "power", "--coefficient", "1", "--power", "0"}),
      "--power = 0: must be from 1 to");
}

BOOST_AUTO_TEST_SUITE_END()

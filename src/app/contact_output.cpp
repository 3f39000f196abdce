// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/contact_output.hpp"

#include <fmt/core.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/json_text.hpp"
#include "app/validity.hpp"
#include "command_line/number_text.hpp"

namespace app {
namespace {

std::vector<double> to_vector(const Eigen::VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

// The half-width: for cylinders from the second moment of the pressure, for other profiles half the
// distance between the edges.
double half_width_of(const ContactInput& input, const line_contact::Solution& solution) {
  if (input.profile == "cylinder") return solution.half_width();
  const auto regions = solution.regions();
  if (regions.empty()) return 0;
  return (regions.back().end - regions.front().begin) / 2;
}

double largest_gap_residual(const line_contact::Residuals& residuals) {
  return std::max(residuals.gap, residuals.separation);
}

nlohmann::ordered_json friction_json(const ContactInput& input, const SolvedContact& solved) {
  nlohmann::ordered_json json;
  json["coefficient"] = *input.friction;
  json["tangential_load"] = solved.friction->tangential_load;
  json["state"] = input.tangential ? "partial slip" : "sliding";
  json["dundurs_beta"] = elasticity::dundurs_beta(input.material1, input.material2);
  return json;
}

nlohmann::ordered_json regions_json(const line_contact::Solution& solution) {
  auto json = nlohmann::ordered_json::array();
  for (const line_contact::Region& region : solution.regions()) {
    json.push_back({{"begin", region.begin},
                    {"end", region.end},
                    {"load", region.load},
                    {"nodes", region.n_nodes}});
  }
  return json;
}

nlohmann::ordered_json closed_form_json(const ClosedForm& exact) {
  nlohmann::ordered_json json;
  json["half_width"] = exact.half_width;
  if (std::isfinite(exact.peak_pressure)) json["peak_pressure"] = exact.peak_pressure;
  return json;
}

std::string regions_text(const line_contact::Solution& solution, const config::UnitSystem& units) {
  std::string text;
  const auto regions = solution.regions();
  constexpr std::size_t most_shown = 10;
  for (std::size_t i = 0; i < std::min(regions.size(), most_shown); ++i) {
    text += fmt::format("  from {:.6g} to {:.6g} {}, {:.6g} {}\n", regions[i].begin, regions[i].end,
                        units.length, regions[i].load, units.line_load);
  }
  if (regions.size() > most_shown) {
    text += fmt::format("  and {} more\n", regions.size() - most_shown);
  }
  return text;
}

}  // namespace

std::vector<std::string> validity_warnings(const ContactInput& input, const SolvedContact& solved) {
  return half_space_warnings(half_width_of(input, solved.solution), input.least_radius);
}

void require_finite(const ContactInput& input, const SolvedContact& solved) {
  const line_contact::Solution& s = solved.solution;
  if (solved.friction) {
    command_line::finite_result("shear", solved.friction->shear.sum());
    command_line::finite_result("slope_of_pressure", solved.slopes->of_pressure.sum());
    command_line::finite_result("slope_of_shear", solved.slopes->of_shear.sum());
  }
  command_line::finite_result("half_width", half_width_of(input, s));
  command_line::finite_result("peak_pressure", s.peak_pressure());
  command_line::finite_result("load", s.line_load());
  command_line::finite_result("approach", solved.approach.value_or(0));
  for (const double residual :
       {s.residuals.gap, s.residuals.separation, s.residuals.pressure, s.residuals.load}) {
    command_line::finite_result("residuals", residual);
  }
  if (input.closed_form) {
    command_line::finite_result("half_width / exact",
                                s.half_width() / input.closed_form->half_width);
    command_line::finite_result("peak_pressure / exact",
                                s.peak_pressure() / input.closed_form->peak_pressure);
  }
  for (Eigen::Index i = 0; i < s.grid.n_nodes; ++i) {
    if (std::isfinite(s.pressure[i]) && std::isfinite(s.gap[i])) continue;
    const double x = s.grid.x(i);
    command_line::finite_result(fmt::format("pressure at x = {}", x), s.pressure[i]);
    command_line::finite_result(fmt::format("gap at x = {}", x), s.gap[i]);
  }
}

std::string contact_json(const ContactInput& input, const SolvedContact& solved) {
  const line_contact::Solution& s = solved.solution;
  nlohmann::ordered_json json;
  json["half_width"] = half_width_of(input, s);
  json["peak_pressure"] = s.peak_pressure();
  json["load"] = s.line_load();
  if (solved.approach) json["approach"] = *solved.approach;
  json["profile"] = input.profile;
  json["element"] = line_contact::name_of(s.element);
  json["method"] = input.method;
  json["nodes"] = s.grid.n_nodes;
  json["nodes_in_contact"] = s.n_in_contact();
  json["solves"] = s.work.solves;
  json["iterations"] = s.work.iterations;
  json["products"] = s.work.products;
  json["seconds"] = solved.seconds;
  json["residuals"] = {{"gap", largest_gap_residual(s.residuals)},
                       {"pressure", s.residuals.pressure},
                       {"load", s.residuals.load}};
  json["contact_regions"] = regions_json(s);
  if (solved.friction) json["friction"] = friction_json(input, solved);
  if (input.closed_form) json[input.closed_form->name] = closed_form_json(*input.closed_form);
  json["x"] = to_vector(s.grid.nodes());
  json["pressure"] = to_vector(s.pressure);
  json["gap"] = to_vector(s.gap);
  if (solved.friction) {
    json["shear"] = to_vector(solved.friction->shear);
    json["slope_of_pressure"] = to_vector(solved.slopes->of_pressure);
    json["slope_of_shear"] = to_vector(solved.slopes->of_shear);
  }
  return json_text(json);
}

std::string contact_csv(const ContactInput& input, const SolvedContact& solved) {
  const line_contact::Solution& s = solved.solution;
  std::string text = "x,pressure";
  if (input.closed_form) {
    text += input.closed_form->name == "hertz" ? ",hertz_pressure" : ",exact_pressure";
  }
  text += ",gap";
  if (solved.friction) text += ",shear,slope_of_pressure,slope_of_shear";
  text += '\n';
  for (Eigen::Index i = 0; i < s.grid.n_nodes; ++i) {
    const double x = s.grid.x(i);
    auto out = std::back_inserter(text);
    fmt::format_to(out, "{},{}", x, s.pressure[i]);
    if (input.closed_form) fmt::format_to(out, ",{}", input.closed_form->pressure(x));
    fmt::format_to(out, ",{}", s.gap[i]);
    if (solved.friction) {
      fmt::format_to(out, ",{},{},{}", solved.friction->shear[i], solved.slopes->of_pressure[i],
                     solved.slopes->of_shear[i]);
    }
    text += '\n';
  }
  return text;
}

std::string contact_text(const ContactInput& input, const SolvedContact& solved,
                         const config::UnitSystem& units) {
  const line_contact::Solution& s = solved.solution;
  std::string text;
  const auto single = [&](const char* name, double value, const std::string& unit) {
    text += fmt::format("{:<16}{:>16.9g}  {}\n", name, value, unit);
  };
  const auto compared = [&](const char* name, double value, double exact, const std::string& unit) {
    text += fmt::format("{:<16}{:>16.9g}{:>16.9g}  {:>10.1e}  {}\n", name, value, exact,
                        value / exact - 1, unit);
  };
  if (const auto& exact = input.closed_form) {
    text += fmt::format("{:<16}{:>16}{:>16}  {:>10}\n", "", "elements",
                        exact->name == "hertz" ? "Hertz" : "closed form", "difference");
    compared("half-width", half_width_of(input, s), exact->half_width, units.length);
    if (std::isfinite(exact->peak_pressure)) {
      compared("peak pressure", s.peak_pressure(), exact->peak_pressure, units.stress);
    } else {
      text += fmt::format("{:<16}{:>16.9g}{:>16}  {:>10}  {}\n", "peak pressure", s.peak_pressure(),
                          "infinite", "", units.stress);
    }
  } else {
    single("half-width", half_width_of(input, s), units.length);
    single("peak pressure", s.peak_pressure(), units.stress);
  }
  single("load", s.line_load(), units.line_load);
  if (solved.approach) single("approach", *solved.approach, units.length);
  if (solved.friction) {
    single("tangential load", solved.friction->tangential_load, units.line_load);
    text += input.tangential ? "partial slip" : "sliding";
    text += fmt::format(", friction {}", *input.friction);
    const double beta = elasticity::dundurs_beta(input.material1, input.material2);
    if (input.tangential && beta != 0) {
      text += fmt::format("; exact for like materials, and here Dundurs' beta is {:.3g}", beta);
    }
    text += '\n';
  }
  const auto regions = s.regions();
  if (regions.size() > 1) {
    text += fmt::format("{} regions in contact\n{}", regions.size(), regions_text(s, units));
  }
  text += fmt::format("{} of {} nodes in contact, {:.6g} {} apart; {}, {} elements",
                      s.n_in_contact(), s.grid.n_nodes, s.grid.spacing, units.length, input.method,
                      line_contact::name_of(s.element));
  if (s.work.solves > 0) text += fmt::format(", steps to find the contact: {}", s.work.solves);
  if (s.work.iterations > 0) text += fmt::format(", {} iterations", s.work.iterations);
  text += fmt::format(
      "\nresiduals: (1a) {:.1e} {}, (1b) {:.1e} {}, pressure {:.1e} {}, load {:.1e} {}\n",
      s.residuals.gap, units.length, s.residuals.separation, units.length, s.residuals.pressure,
      units.stress, s.residuals.load, units.line_load);
  return text;
}

}  // namespace app

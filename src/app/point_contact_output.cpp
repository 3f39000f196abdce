// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/point_contact_output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/json_text.hpp"
#include "command_line/number_text.hpp"
#include "point_contact/solver/regions.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;
using point_contact::Vector2;

ordered_json closed_form_json(const PointClosedForm& exact) {
  ordered_json json;
  if (std::isfinite(exact.peak_pressure)) json["peak_pressure"] = exact.peak_pressure;
  json["half_widths"] = {std::max(exact.half_width_x, exact.half_width_y),
                         std::min(exact.half_width_x, exact.half_width_y)};
  json["approach"] = exact.approach;
  json["load"] = exact.load;
  return json;
}

ordered_json friction_json(const PointContactInput& input, const SolvedPointContact& solved) {
  const point_contact::Friction& friction = *solved.friction;
  ordered_json json;
  json["coefficient"] = *input.friction;
  json["tangential_load"] = friction.tangential_load;
  json["state"] = input.tangential ? "partial slip" : "sliding";
  json["nodes_sticking"] = friction.n_sticking;
  json["stick_area"] =
      static_cast<double>(friction.n_sticking) * solved.solution.grid.lattice.cell_area();
  if (solved.tangential_displacement) json["displacement"] = *solved.tangential_displacement;
  json["dundurs_beta"] = elasticity::dundurs_beta(input.material1, input.material2);
  if (input.hertz && input.tangential) {
    const point_contact::CattaneoMindlin exact(*input.hertz, *input.friction, *input.tangential);
    const double compliance =
        point_contact::tangential_compliance(input.material1, input.material2);
    json["cattaneo_mindlin"] = {{"stick_radius", exact.stick_radius()},
                                {"displacement", exact.displacement(compliance)}};
  }
  return json;
}

ordered_json regions_json(const point_contact::Solution& solution) {
  auto json = ordered_json::array();
  for (const point_contact::Region& region : point_contact::regions(solution)) {
    json.push_back({{"x", region.centre.x()},
                    {"y", region.centre.y()},
                    {"load", region.load},
                    {"area", region.area},
                    {"nodes", region.n_nodes}});
  }
  return json;
}

std::string point_regions_text(const point_contact::Solution& solution,
                               const config::UnitSystem& units) {
  const auto regions = point_contact::regions(solution);
  if (regions.size() < 2) return "";
  constexpr std::size_t most_shown = 10;
  std::string text = fmt::format("{} regions in contact\n", regions.size());
  for (std::size_t i = 0; i < std::min(regions.size(), most_shown); ++i) {
    const point_contact::Region& region = regions[i];
    text +=
        fmt::format("  {:.6g} {} about ({:.6g}, {:.6g}) {}, {} nodes\n", region.load, units.force,
                    region.centre.x(), region.centre.y(), units.length, region.n_nodes);
  }
  if (regions.size() > most_shown)
    text += fmt::format("  and {} more\n", regions.size() - most_shown);
  return text;
}

}  // namespace

Vector2 half_widths_of(const PointContactInput& input, const point_contact::Solution& solution) {
  return input.curvatures ? solution.semi_axes() : solution.area_semi_axes();
}

void require_finite(const PointContactInput& input, const SolvedPointContact& solved) {
  using command_line::finite_result;
  const point_contact::Solution& s = solved.solution;
  finite_result("half_widths", half_widths_of(input, s).sum());
  finite_result("peak_pressure", s.peak_pressure());
  finite_result("load", s.load());
  finite_result("approach", s.approach);
  finite_result("contact_area", s.contact_area());
  if (solved.friction) finite_result("shear", solved.friction->shear.sum());
  for (const double residual :
       {s.residuals.gap, s.residuals.separation, s.residuals.pressure, s.residuals.load}) {
    finite_result("residuals", residual);
  }
  // Where there is no body its distance is infinite, which CSV says as inf.
  for (Eigen::Index node = 0; node < s.pressure.size(); ++node) {
    if (!std::isfinite(s.pressure[node])) finite_result("pressure", s.pressure[node]);
  }
}

std::string point_contact_json(const PointContactInput& input, const SolvedPointContact& solved) {
  const point_contact::Solution& s = solved.solution;
  const Vector2 widths = half_widths_of(input, s);
  ordered_json json;
  json["peak_pressure"] = s.peak_pressure();
  json["half_widths"] = {widths[0], widths[1]};
  json["approach"] = s.approach;
  json["load"] = s.load();
  json["contact_area"] = s.contact_area();
  json["profile"] = input.profile;
  if (input.curvatures) json["angle"] = input.curvatures->angle * 180 / std::numbers::pi;
  json["element"] = point_contact::name_of(s.element);
  json["grid"] = input.grid;
  json["method"] = input.method;
  json["nodes"] = s.grid.n1;
  json["rows"] = s.grid.n2;
  json["nodes_in_contact"] = s.n_in_contact();
  json["seconds"] = solved.seconds;
  json["work"] = {{"products", s.work.products},
                  {"preconditionings", s.work.preconditionings},
                  {"iterations", s.work.iterations},
                  {"revisions", s.work.revisions}};
  json["residuals"] = {{"gap", s.residuals.gap},
                       {"separation", s.residuals.separation},
                       {"pressure", s.residuals.pressure},
                       {"load", s.residuals.load}};
  json["contact_regions"] = regions_json(s);
  if (solved.friction) json["friction"] = friction_json(input, solved);
  if (input.closed_form) json[input.closed_form->name] = closed_form_json(*input.closed_form);
  return json_text(json);
}

std::string point_contact_csv(const SolvedPointContact& solved) {
  const point_contact::Solution& s = solved.solution;
  std::string text = "x,y,pressure,gap";
  if (solved.friction) text += ",shear";
  text += '\n';
  constexpr Eigen::Index usual_line = 70;
  text.reserve(static_cast<std::size_t>(usual_line * s.grid.size()));
  auto out = std::back_inserter(text);
  for (Eigen::Index j = 0; j < s.grid.n2; ++j) {
    for (Eigen::Index i = 0; i < s.grid.n1; ++i) {
      const Eigen::Index node = s.grid.index(i, j);
      const Vector2 at = s.grid.node(i, j);
      fmt::format_to(out, "{},{},{},{}", at.x(), at.y(), s.pressure[node], s.gap[node]);
      if (solved.friction) fmt::format_to(out, ",{}", solved.friction->shear[node]);
      text += '\n';
    }
  }
  return text;
}

std::string point_contact_text(const PointContactInput& input, const SolvedPointContact& solved,
                               const config::UnitSystem& units) {
  const point_contact::Solution& s = solved.solution;
  const Vector2 widths = half_widths_of(input, s);
  std::string text;
  const auto row = [&](const char* name, double value, std::optional<double> exact,
                       const std::string& unit) {
    if (!exact) {
      text += fmt::format("{:<22}{:>16.9g}  {}\n", name, value, unit);
    } else if (std::isfinite(*exact)) {
      text += fmt::format("{:<22}{:>16.9g}{:>16.9g}  {:>10.1e}  {}\n", name, value, *exact,
                          value / *exact - 1, unit);
    } else {
      text += fmt::format("{:<22}{:>16.9g}{:>16}  {:>10}  {}\n", name, value, "infinite", "", unit);
    }
  };
  const auto& exact = input.closed_form;
  const auto of_exact = [&](auto member) -> std::optional<double> {
    if (!exact) return std::nullopt;
    return (*exact).*member;
  };
  if (exact) {
    text += fmt::format("{:<22}{:>16}{:>16}  {:>10}\n", "", "elements",
                        exact->name == "hertz" ? "Hertz" : "closed form", "difference");
  }
  std::optional<double> longer, shorter;
  if (exact) {
    longer = std::max(exact->half_width_x, exact->half_width_y);
    shorter = std::min(exact->half_width_x, exact->half_width_y);
  }
  row("half-width, greatest", widths[0], longer, units.length);
  row("half-width, least", widths[1], shorter, units.length);
  row("peak pressure", s.peak_pressure(), of_exact(&PointClosedForm::peak_pressure), units.stress);
  row("approach", s.approach, of_exact(&PointClosedForm::approach), units.length);
  row("load", s.load(), of_exact(&PointClosedForm::load), units.force);
  if (input.curvatures && !input.is_of_revolution) {
    text += fmt::format("the contact is longest at {:.6g} degrees from the x axis of body 1\n",
                        input.curvatures->angle * 180 / std::numbers::pi);
  }
  if (solved.friction) {
    row("tangential load", solved.friction->tangential_load, std::nullopt, units.force);
    if (solved.tangential_displacement) {
      std::optional<double> mindlin;
      if (input.hertz) {
        mindlin = point_contact::CattaneoMindlin(*input.hertz, *input.friction, *input.tangential)
                      .displacement(
                          point_contact::tangential_compliance(input.material1, input.material2));
      }
      row("tangential approach", *solved.tangential_displacement, mindlin, units.length);
    }
    text += input.tangential ? "partial slip" : "sliding";
    text += fmt::format(", friction {}", *input.friction);
    if (input.tangential) text += fmt::format(", {} nodes stick", solved.friction->n_sticking);
    const double beta = elasticity::dundurs_beta(input.material1, input.material2);
    if (input.tangential && beta != 0) {
      text += fmt::format("; for like materials, and here Dundurs' beta is {:.3g}", beta);
    }
    text += '\n';
  }
  text += point_regions_text(s, units);
  text += fmt::format("{} of {} x {} nodes in contact, {:.6g} {} apart; {}, {} grid, {} elements",
                      s.n_in_contact(), s.grid.n1, s.grid.n2, s.grid.lattice.first.norm(),
                      units.length, input.method, input.grid, point_contact::name_of(s.element));
  text += fmt::format("\n{:.3g} s, {} products and {} preconditionings on these nodes\n",
                      solved.seconds, s.work.products, s.work.preconditionings);
  text +=
      fmt::format("residuals: (1a) {:.1e} {}, (1b) {:.1e} {}, pressure {:.1e} {}, load {:.1e} {}\n",
                  s.residuals.gap, units.length, s.residuals.separation, units.length,
                  s.residuals.pressure, units.stress, s.residuals.load, units.force);
  return text;
}

}  // namespace app

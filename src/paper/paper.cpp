// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/paper.hpp"

#include <fmt/core.h>

#include <future>

#include "config/table.hpp"

namespace paper {
namespace {

// Rejects cases that the commands can compute but for which a sentence of the report is false.
void require_reportable(const parameters::Case& c) {
  const auto table = [&](const char* name) {
    return config::Table::parse_file(c.file).table(name);  // has the position of the number
  };
  const double half_width = c.half_space.load.half_width();
  if (c.half_space.datum < half_width) {
    table("half_space")
        .fail("datum",
              fmt::format("{0:.12g} {1}: must be at least half_space.load.half_width, {2:.6g} "
                          "{1}, for the report",
                          c.half_space.datum, c.units.length, half_width));
  }
  constexpr long most_nodes = 401;  // the reference methods are dense
  if (c.contact.n_nodes > most_nodes) {
    table("contact").fail("nodes", fmt::format("{}: must be at most {} for the report",
                                               c.contact.n_nodes, most_nodes));
  }
}

}  // namespace

std::string compute(Document& document, const parameters::Case& from_file) {
  require_reportable(from_file);
  Case from{from_file, read_printed(from_file)};
  std::string log;
  if (from.printed_data) {
    const std::string other = difference_from_paper(from_file, *from.printed_data);
    if (!other.empty()) {
      log = fmt::format("{}: {}; the report omits the sections about the paper's numbers",
                        from.file.string(), other);
      from.printed_data.reset();
    }
  }
  document.flag("printed", from.printed_data.has_value());
  document.flag("block", from.block.has_value());
  document.flag("point-contact", from.point_contact.has_value());
  document.value("case.title", Value::text(from.title));

  std::vector<std::future<Document>> parts;
  for (const Section& section : sections()) {
    parts.push_back(std::async(std::launch::async, [&] {
      Document part;
      section.compute(part, from);
      return part;
    }));
  }
  for (auto& part : parts) document.append(part.get());
  return log;
}

const std::vector<Section>& sections() {
  static const std::vector<Section> list = {{"formulation", &compute_formulation},
                                            {"quadrature", &compute_quadrature},
                                            {"results", &compute_results},
                                            {"error_analysis", &compute_error_analysis},
                                            {"block", &compute_block},
                                            {"tangential", &compute_tangential},
                                            {"cylinders", &compute_cylinders},
                                            {"contact_m", &compute_contact_m},
                                            {"elements", &compute_elements},
                                            {"spheres", &compute_spheres}};
  return list;
}

}  // namespace paper

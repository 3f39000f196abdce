// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/registered.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

namespace literate {

std::vector<Check> failed_checks(const Registered& registered) {
  std::vector<Check> failed;
  std::ranges::copy_if(registered.checks, std::back_inserter(failed),
                       [](const Check& check) { return !check.passed; });
  return failed;
}

std::map<std::string, std::string> figure_places(const Registered& registered) {
  std::map<std::string, std::string> places;
  for (const auto& [name, figure] : registered.figures) {
    places[name] = text_of(registered.places.at({"figure", name}));
  }
  return places;
}

std::vector<std::string> faults(const Registered& registered) {
  const auto place_of = [&](const char* kind, const std::string& name) {
    return text_of(registered.places.at({kind, name}));
  };
  std::vector<std::string> faults;
  for (const Check& check : failed_checks(registered)) {
    faults.push_back(fmt::format("{}: check {} failed: {}{}{}", place_of("check", check.id),
                                 check.id, check.statement, check.found.empty() ? "" : "; ",
                                 check.found));
  }
  for (const auto& [id, claim] : registered.claims) {
    if (claim.found() == claim.expected) continue;
    faults.push_back(fmt::format("{}: claim {} is {}, not {}: {}", place_of("claim", id), id,
                                 name_of(claim.found()), name_of(claim.expected),
                                 text_of(claim.criteria)));
  }
  return faults;
}

}  // namespace literate

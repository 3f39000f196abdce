// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/registered.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <iterator>
#include <mutex>

namespace literate {
namespace {

/// Shortens «void paper::{anonymous}::f(literate::Document&)» to «paper::f».
std::string short_name(std::string_view signature) {
  const std::size_t end = signature.find('(');
  std::string name(signature.substr(0, end));
  for (std::string_view part : {"{anonymous}::", "(anonymous namespace)::"}) {
    const std::size_t at = name.find(part);
    if (at != std::string::npos) name.erase(at, part.size());
  }
  const std::size_t space = name.rfind(' ');
  return space == std::string::npos ? name : name.substr(space + 1);
}

}  // namespace

SourcePlace place_of(const std::source_location& location) {
  return {location.file_name(), short_name(location.function_name()), location.line(),
          location.column()};
}

std::string text_of(const SourcePlace& place) {
  return fmt::format("{}:{}", place.file, place.line);
}

namespace {

std::mutex registering;
std::deque<std::string> all_told;  // whose texts stay where they are
std::atomic<const std::string*> last_told = nullptr;

}  // namespace

void remember_last_registered(const std::string& what) {
  const std::lock_guard lock(registering);
  last_told = &all_told.emplace_back(what);
}

std::string_view last_registered() {
  const std::string* const text = last_told;
  return text == nullptr ? "nothing" : std::string_view(*text);
}

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

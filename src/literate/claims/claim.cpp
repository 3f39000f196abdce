// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/claim.hpp"

#include <fmt/core.h>

namespace literate {
namespace {

// «void paper::{anonymous}::f(literate::Document&)» becomes «paper::f».
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

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::partly:
      return "partly confirmed";
    case Verdict::refuted:
      break;
  }
  return "refuted";
}

Verdict confirmed_if(bool holds) {
  return holds ? Verdict::confirmed : Verdict::refuted;
}

Verdict confirmed_in(long n_holding, long n_cases) {
  if (n_holding == 0) return Verdict::refuted;
  return n_holding == n_cases ? Verdict::confirmed : Verdict::partly;
}

std::string text_of(const SourcePlace& place) {
  return fmt::format("{}:{}", place.file, place.line);
}

SourcePlace place_of(const std::source_location& location) {
  return {location.file_name(), short_name(location.function_name()), location.line()};
}

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/document/source_place.hpp"

#include <fmt/core.h>

#include <string_view>

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

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/text/place.hpp"

#include <fmt/core.h>

namespace literate {

Place::Place(const std::source_location& location)
    : text(fmt::format("{}:{}", location.file_name(), location.line())) {}

void fail_at(const Place& place, std::string_view message) {
  throw Error(fmt::format("{}: {}", place.text, message));
}

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace app {

/// A JSON value as indented text with the shortest digits that round-trip for every number.
/// (nlohmann's own dump() uses Grisu2, which misses the shortest about once in a thousand.)
/// Throws sys::InputError for a number that is not finite, which JSON cannot say.
std::string json_text(const nlohmann::ordered_json& value);

}  // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/json_text.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "command_line/number_text.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;

bool is_flat(const ordered_json& value) {
  for (const auto& element : value) {
    if (element.is_structured()) return false;
  }
  return true;
}

std::string text_of(const ordered_json& value, const std::string& indent) {
  if (value.is_number_float()) {
    return command_line::shortest(
        command_line::finite_result("a number of the JSON", value.get<double>()));
  }
  if (!value.is_structured()) return value.dump();
  const bool on_one_line = value.is_array() && is_flat(value);
  const std::string inner = on_one_line ? "" : "\n" + indent + "  ";
  std::string text;
  for (const auto& [key, element] : value.items()) {
    text += text.empty() ? inner : "," + (on_one_line ? std::string(" ") : inner);
    if (value.is_object()) text += ordered_json(key).dump() + ": ";
    text += text_of(element, indent + "  ");
  }
  if (!on_one_line && !text.empty()) text += "\n" + indent;
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& value) {
  return text_of(value, "") + "\n";
}

}  // namespace app

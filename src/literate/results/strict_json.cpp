// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/results/strict_json.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <set>

#include "literate/text/place.hpp"
#include "system/files.hpp"
#include "system/nearest_name.hpp"

namespace literate {

StrictJson StrictJson::parse_file(const std::filesystem::path& file) {
  const std::string text = sys::read_file(file);
  const std::string name = file.generic_string();
  std::vector<std::pair<std::string, std::set<std::string>>> open;  // open objects with their key
  std::string last_key;
  const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start)
      open.emplace_back(last_key, std::set<std::string>());
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event != Json::parse_event_t::key) return true;
    last_key = parsed.get<std::string>();
    if (open.back().second.insert(last_key).second) return true;
    const std::string& within = open.back().first;
    throw Error(fmt::format("{}: the key '{}' is given twice{}", name, last_key,
                            within.empty() ? "" : fmt::format(" in '{}'", within)));
  };
  try {
    return {std::make_shared<const Json>(Json::parse(text, watch)), name, ""};
  } catch (const Json::exception& error) {
    // «[json.exception.parse_error.101] parse error at line 3, column 5: …»
    const std::string_view what = error.what();
    const auto end = what.find("] ");
    throw Error(fmt::format("{}: {}", name, end == what.npos ? what : what.substr(end + 2)));
  }
}

StrictJson StrictJson::child(const Json& json, const std::string& name) const {
  return {std::shared_ptr<const Json>(json_, &json), file_,
          path_.empty() ? name : path_ + "." + name};
}

void StrictJson::fail(std::string_view message) const {
  throw Error(fmt::format("{}: {}{}", file_, path_.empty() ? "" : path_ + ": ", message));
}

void StrictJson::require(bool is_of_type, std::string_view what) const {
  if (!is_of_type) fail(fmt::format("must be {}, not {}", what, json_->dump().substr(0, 40)));
}

void StrictJson::require_keys(std::initializer_list<std::string_view> allowed) const {
  require(json_->is_object(), "an object");
  for (const auto& [key, value] : json_->items()) {
    if (std::ranges::find(allowed, key) != allowed.end()) continue;
    fail(fmt::format("unknown key '{}'{}", key,
                     sys::suggestion(key, std::set<std::string>(allowed.begin(), allowed.end()))));
  }
}

bool StrictJson::has(const std::string& key) const {
  return json_->is_object() && json_->contains(key);
}

StrictJson StrictJson::operator[](const std::string& key) const {
  require(json_->is_object(), "an object");
  if (!has(key)) fail(fmt::format("the key '{}' is missing", key));
  return child((*json_)[key], key);
}

std::optional<StrictJson> StrictJson::find(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  return (*this)[key];
}

std::vector<std::pair<std::string, StrictJson>> StrictJson::entries() const {
  require(json_->is_object(), "an object");
  std::vector<std::pair<std::string, StrictJson>> entries;
  for (const auto& [key, value] : json_->items()) entries.emplace_back(key, child(value, key));
  return entries;
}

std::vector<StrictJson> StrictJson::elements() const {
  require(json_->is_array(), "a list");
  std::vector<StrictJson> elements;
  for (const Json& value : *json_) {
    elements.push_back(child(value, std::to_string(elements.size() + 1)));
  }
  return elements;
}

std::string StrictJson::text() const {
  require(json_->is_string(), "a text");
  return json_->get<std::string>();
}

double StrictJson::number() const {
  require(json_->is_number(), "a number");
  return json_->get<double>();
}

int StrictJson::integer() const {
  constexpr auto most = std::numeric_limits<int>::max();
  require(json_->is_number_integer() && std::abs(json_->get<double>()) < most, "a whole number");
  return json_->get<int>();
}

bool StrictJson::boolean() const {
  require(json_->is_boolean(), "true or false");
  return json_->get<bool>();
}

}  // namespace literate

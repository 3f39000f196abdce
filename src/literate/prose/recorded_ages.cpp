// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/prose/recorded_ages.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <nlohmann/json.hpp>

#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {

RecordedAges::RecordedAges(const std::filesystem::path& document, const Names& names) {
  using Texts = std::map<std::string, std::string>;
  const std::filesystem::path file = document / "results.json";
  Texts limits, ages;
  if (std::filesystem::exists(file)) {
    try {
      const auto record = nlohmann::json::parse(sys::read_file(file));
      limits = record.at("limits").get<Texts>();
      ages = record.value("ages", Texts());
      // In another case a limit is no older than its verdict, though it was chosen after one.
      if (record.at("inputs") != nlohmann::json{{"case", names.case_sha256}}) {
        std::erase_if(ages, [](const auto& age) { return age.second == older_than_verdict; });
      }
    } catch (const nlohmann::json::exception&) {
      throw sys::OutputError(fmt::format(
          "'{}' is no record of results; the check with RECORD=1 writes it anew", file.string()));
    }
  }
  for (const auto& [id, claim] : names.claims) {
    for (const NamedLimit& limit : claim.limits) {
      const std::string what = fmt::format("claim {}: {}", id, limit.quantity);
      const auto age = ages.find(what);
      const auto recorded = limits.find(what);
      const bool is_known = age != ages.end() && recorded != limits.end() &&
                            recorded->second == limit.condition &&
                            (age->second == chosen_after || age->second == older_than_verdict);
      ages_[id].push_back(is_known ? age->second : "");
    }
  }
}

std::string RecordedAges::latex() const {
  std::string text;
  for (const auto& [id, ages] : ages_) {
    for (std::size_t i = 0; i < ages.size(); ++i) {
      if (ages[i].empty()) continue;
      text += fmt::format("\\LiterateLimitAge{{{}}}{{{}}}{{{}}}\n", id, i + 1, ages[i]);
    }
  }
  return text;
}

}  // namespace literate

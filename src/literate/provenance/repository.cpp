// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/provenance/repository.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {

Repository read_repository(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "repository.json";
  try {
    const auto facts = nlohmann::json::parse(sys::read_file(file));
    const auto& engine = facts.at("engine");
    return {.commit = facts.at("commit").get<std::string>(),
            .modified = facts.at("modified").get<bool>(),
            .date = facts.at("date").get<std::string>(),
            .engine_commit = engine.at("commit").get<std::string>(),
            .engine_modified = engine.at("modified").get<bool>()};
  } catch (const nlohmann::json::exception&) {
    throw sys::OutputError(
        fmt::format("'{}' does not tell the state of a repository", file.string()));
  }
}

}  // namespace literate

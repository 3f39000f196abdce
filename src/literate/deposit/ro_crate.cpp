// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/deposit/ro_crate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "system/error.hpp"

namespace literate {
namespace {

using nlohmann::json;

constexpr const char* specification = "https://w3id.org/ro/crate/1.1";

/// A path as a URI reference: what may not stand in one is written as %XX, bytes beyond ASCII stay.
std::string uri_path(std::string_view path) {
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/!$&'()*+,;=@";
  std::string uri;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool stands = byte >= 0x80 || allowed.find(c) != allowed.npos;
    uri += stands ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return uri;
}

json reference_to(const json& entity) {
  return {{"@id", entity.at("@id")}};
}

/// References to all entities: one alone stands without a list around it, as the compact form
/// wants.
json references_to(const std::vector<json>& entities) {
  if (entities.size() == 1) return reference_to(entities.front());
  json list = json::array();
  for (const json& entity : entities) list.push_back(reference_to(entity));
  return list;
}

void set_unless_empty(json& entity, const char* property, const std::string& text) {
  if (!text.empty()) entity[property] = text;
}

std::vector<json> author_entities(const std::vector<Author>& authors, const std::string& prefix) {
  std::vector<json> entities;
  for (const Author& author : authors) {
    entities.push_back(
        {{"@id", author.orcid.empty() ? fmt::format("#{}author-{}", prefix, entities.size() + 1)
                                      : author.orcid},
         {"@type", author.is_person ? "Person" : "Organization"},
         {"name", author.name}});
  }
  return entities;
}

json file_entity(const DepositedFile& file) {
  json entity{{"@id", uri_path(file.name)},
              {"@type", "File"},
              {"name", file.name},
              {"contentSize", std::to_string(file.size)},
              {"sha256", file.sha256}};
  set_unless_empty(entity, "encodingFormat", media_type(file.name));
  return entity;
}

/// Inputs of the run that are not in the folder.
std::vector<json> outside_inputs(const Manifest& manifest,
                                 const std::vector<DepositedFile>& files) {
  std::vector<json> entities;
  for (const auto& [name, sha256] : manifest.inputs) {
    const bool is_inside = std::ranges::any_of(
        files, [&digest = sha256](const DepositedFile& file) { return file.sha256 == digest; });
    if (is_inside) continue;
    entities.push_back({{"@id", "#input/" + uri_path(name)},
                        {"@type", "CreativeWork"},
                        {"name", name},
                        {"sha256", sha256}});
  }
  return entities;
}

/// The libraries and tools that the manifest tells of.
std::vector<json> software_entities(const Manifest& manifest) {
  std::vector<json> entities;
  for (const char* part : {"libraries", "tools"}) {
    const auto facts = manifest.facts.find(part);
    if (facts == manifest.facts.end()) continue;
    for (const auto& [name, version] : facts->second) {
      entities.push_back({{"@id", "#software/" + uri_path(name)},
                          {"@type", "SoftwareApplication"},
                          {"name", name},
                          {"version", version}});
    }
  }
  return entities;
}

std::string fact_of_sources(const Manifest& manifest, const std::string& name) {
  const auto sources = manifest.facts.find("sources");
  if (sources == manifest.facts.end()) return "";
  const auto fact = sources->second.find(name);
  return fact == sources->second.end() || fact->second == "unknown" ? "" : fact->second;
}

std::string date_of(const Citation& citation, const Manifest& manifest) {
  const std::string date = fact_of_sources(manifest, "date");
  if (!date.empty()) return date;
  if (!citation.date.empty()) return citation.date;
  throw sys::InputError(
      "neither the manifest nor the citation has a date: set SOURCE_DATE_EPOCH for the build");
}

json license_entity(const Citation& citation) {
  if (citation.license.empty()) throw sys::InputError("the citation names no license");
  return {
      {"@id", "https://spdx.org/licenses/" + uri_path(citation.license)},
      {"@type", "CreativeWork"},
      {"name", citation.license},
      {"description", fmt::format("The license with the SPDX identifier {}", citation.license)}};
}

/// The works that this one cites, and behind each its authors.
std::vector<json> cited_works(const Citation& citation, std::vector<json>& authors_of_works) {
  std::vector<json> works;
  for (const Reference& reference : citation.references) {
    const std::string number = std::to_string(works.size() + 1);
    const auto authors = author_entities(reference.authors, fmt::format("work-{}-", number));
    json work{
        {"@id", reference.doi.empty() ? "#work-" + number : "https://doi.org/" + reference.doi},
        {"@type", "CreativeWork"},
        {"name", reference.title},
        {"author", references_to(authors)}};
    set_unless_empty(work, "datePublished", reference.date);
    set_unless_empty(work, "description", reference.notes);
    works.push_back(std::move(work));
    authors_of_works.insert(authors_of_works.end(), authors.begin(), authors.end());
  }
  return works;
}

json program_entity(const Citation& citation, const Manifest& manifest,
                    const std::vector<json>& authors, const std::vector<json>& software,
                    const json& license) {
  json program{{"@id", "#program"},
               {"@type", json::array({"SoftwareApplication", "SoftwareSourceCode"})},
               {"name", manifest.project},
               {"author", references_to(authors)},
               {"license", reference_to(license)}};
  const std::string commit = fact_of_sources(manifest, "commit");
  const std::string version = fact_of_sources(manifest, "version");
  set_unless_empty(program, "version",
                   commit.empty() ? version : fmt::format("{}, commit {}", version, commit));
  set_unless_empty(program, "codeRepository", citation.repository);
  if (!software.empty()) program["softwareRequirements"] = references_to(software);
  return program;
}

json root_entity(const Citation& citation, const Manifest& manifest) {
  const std::string description =
      citation.abstract.empty()
          ? fmt::format(
                "{}, as the program {} computed it: the document, its data, and the manifest of "
                "what they were made from and with.",
                citation.title, manifest.project)
          : citation.abstract;
  json root{{"@id", "./"},
            {"@type", "Dataset"},
            {"name", citation.title},
            {"description", description},
            {"datePublished", date_of(citation, manifest)}};
  if (!citation.doi.empty()) root["identifier"] = "https://doi.org/" + citation.doi;
  return root;
}

}  // namespace

std::string ro_crate_json(const Citation& citation, const Manifest& manifest,
                          const std::vector<DepositedFile>& files) {
  const json descriptor{{"@id", "ro-crate-metadata.json"},
                        {"@type", "CreativeWork"},
                        {"conformsTo", {{"@id", specification}}},
                        {"about", {{"@id", "./"}}}};

  // Describe what lies in the folder, and which of it went into the run or came out.
  std::vector<json> parts;
  std::vector<json> objects = outside_inputs(manifest, files);
  const std::vector<json> outside = objects;
  std::vector<json> results;
  for (const DepositedFile& file : files) {
    parts.push_back(file_entity(file));
    if (file.part == Part::input) objects.push_back(parts.back());
    if (file.part == Part::output) results.push_back(parts.back());
  }

  // Describe who and what made it.
  const json license = license_entity(citation);
  const std::vector<json> authors = author_entities(citation.authors, "");
  const std::vector<json> software = software_entities(manifest);
  std::vector<json> authors_of_works;
  const std::vector<json> works = cited_works(citation, authors_of_works);
  const json program = program_entity(citation, manifest, authors, software, license);
  const json action{{"@id", "#run"},
                    {"@type", "CreateAction"},
                    {"name", fmt::format("Run of {}", manifest.project)},
                    {"agent", references_to(authors)},
                    {"instrument", reference_to(program)},
                    {"object", references_to(objects)},
                    {"result", references_to(results)}};
  json root = root_entity(citation, manifest);
  root["license"] = reference_to(license);
  root["author"] = references_to(authors);
  root["hasPart"] = references_to(parts);
  root["mentions"] = reference_to(action);
  if (!works.empty()) root["citation"] = references_to(works);

  json graph = json::array({descriptor, root});
  for (const auto& entities : {parts, outside, authors, software, works, authors_of_works}) {
    for (const json& entity : entities) graph.push_back(entity);
  }
  for (const json& entity : {license, program, action}) graph.push_back(entity);
  const json context = json::array(
      {std::string(specification) + "/context", {{"sha256", "http://schema.org/sha256"}}});
  return json{{"@context", context}, {"@graph", graph}}.dump(2) + "\n";
}

}  // namespace literate

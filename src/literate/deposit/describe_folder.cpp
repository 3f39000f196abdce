// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/deposit/describe_folder.hpp"

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace fs = std::filesystem;
namespace {

bool holds_digest(const Manifest::Texts& digests, const std::string& sha256) {
  return std::ranges::any_of(digests, [&](const auto& entry) { return entry.second == sha256; });
}

}  // namespace

std::vector<DepositedFile> deposited_files(const fs::path& folder, const Manifest& manifest) {
  std::vector<DepositedFile> files;
  for (const std::string& name : sys::files_below(folder)) {
    DepositedFile file{.name = name,
                       .sha256 = sys::sha256_of_file(folder / name),
                       .size = fs::file_size(folder / name)};
    if (holds_digest(manifest.outputs, file.sha256)) {
      file.part = Part::output;
    } else if (holds_digest(manifest.inputs, file.sha256)) {
      file.part = Part::input;
    }
    files.push_back(std::move(file));
  }
  return files;
}

namespace {

/// The media type that the end of a file's name tells; empty if it is not known.
std::string media_type(const std::string& name) {
  std::istringstream types(R"(
.pdf application/pdf  .csv text/csv  .json application/json  .toml application/toml
.cff application/yaml  .yml application/yaml  .html text/html  .svg image/svg+xml
.png image/png  .tex text/x-tex  .dat text/plain  .gp text/plain  .m text/x-octave
.txt text/plain
)");
  for (std::string ending, type; types >> ending >> type;) {
    if (name.ends_with(ending)) return type;
  }
  return "";
}

void write_text(YAML::Emitter& out, const char* field, const std::string& text) {
  if (!text.empty()) out << YAML::Key << field << YAML::Value << YAML::DoubleQuoted << text;
}

/// What an output is, told from its place among the generated files.
std::string comment_on(const std::string& name) {
  const fs::path path = name;
  const std::string folder = path.parent_path().filename().string();
  const std::string stem = path.stem().string();
  if (folder == "tables") return fmt::format("table {}", stem);
  if (folder == "figures") return fmt::format("figure {}", stem);
  return path.extension() == ".pdf" ? "the whole document" : "";
}

void write_manifest(YAML::Emitter& out, const std::vector<DepositedFile>& files) {
  out << YAML::Key << "manifest" << YAML::Value << YAML::BeginSeq;
  for (const DepositedFile& file : files) {
    if (file.part != Part::output) continue;
    out << YAML::BeginMap;
    write_text(out, "file", file.name);
    write_text(out, "comment", comment_on(file.name));
    out << YAML::EndMap;
  }
  out << YAML::EndSeq;
}

void write_paper(YAML::Emitter& out, const Citation& citation) {
  out << YAML::Key << "paper" << YAML::Value << YAML::BeginMap;
  write_text(out, "title", citation.title);
  out << YAML::Key << "authors" << YAML::Value << YAML::BeginSeq;
  for (const Author& author : citation.authors) {
    out << YAML::BeginMap;
    write_text(out, "name", author.name);
    // The specification wants the number alone.
    write_text(out, "ORCID", author.orcid.substr(author.orcid.rfind('/') + 1));
    out << YAML::EndMap;
  }
  out << YAML::EndSeq;
  write_text(out, "reference",
             citation.doi.empty() ? citation.url : "https://doi.org/" + citation.doi);
  out << YAML::EndMap;
}

/// Of the sources that the outputs were made from; empty if it is not told or not known.
std::string fact_of_sources(const Manifest& manifest, const std::string& name) {
  const auto sources = manifest.facts.find("sources");
  if (sources == manifest.facts.end()) return "";
  const auto fact = sources->second.find(name);
  return fact == sources->second.end() || fact->second == "unknown" ? "" : fact->second;
}

}  // namespace

std::string codecheck_yml(const Citation& citation, const Manifest& manifest,
                          const std::vector<DepositedFile>& files) {
  const auto is_output = [](const DepositedFile& file) { return file.part == Part::output; };
  if (std::ranges::none_of(files, is_output)) {
    throw sys::InputError("the folder holds none of the outputs that the manifest tells of");
  }
  YAML::Emitter out;
  out << YAML::BeginDoc << YAML::BeginMap;
  write_text(out, "version", "https://codecheck.org.uk/spec/config/1.0/");
  write_manifest(out, files);
  write_paper(out, citation);
  const std::string commit = fact_of_sources(manifest, "commit");
  if (!commit.empty()) {
    write_text(out, "source", fmt::format("commit {} of {}", commit, manifest.project));
  }
  write_text(out, "repository", citation.repository);
  out << YAML::EndMap;
  return fmt::format("%YAML 1.1\n{}\n", out.c_str());
}

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

std::vector<json> author_entities(const std::vector<Author>& authors) {
  std::vector<json> entities;
  for (const Author& author : authors) {
    entities.push_back(
        {{"@id",
          author.orcid.empty() ? fmt::format("#author-{}", entities.size() + 1) : author.orcid},
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
    const auto same = std::ranges::find(files, sha256, &DepositedFile::sha256);
    if (same != files.end()) continue;
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
  const std::vector<json> authors = author_entities(citation.authors);
  const std::vector<json> software = software_entities(manifest);
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

  json graph = json::array({descriptor, root});
  for (const auto& entities : {parts, outside, authors, software}) {
    for (const json& entity : entities) graph.push_back(entity);
  }
  for (const json& entity : {license, program, action}) graph.push_back(entity);
  const json context = json::array(
      {std::string(specification) + "/context", {{"sha256", "http://schema.org/sha256"}}});
  return json{{"@context", context}, {"@graph", graph}}.dump(2) + "\n";
}

void describe_folder(const std::filesystem::path& folder, const Manifest& manifest,
                     const Citation& citation) {
  const std::filesystem::path codecheck = folder / "codecheck.yml";
  const std::filesystem::path crate = folder / "ro-crate-metadata.json";
  std::filesystem::remove(codecheck);
  std::filesystem::remove(crate);
  sys::write_file_atomically(codecheck,
                             codecheck_yml(citation, manifest, deposited_files(folder, manifest)));
  sys::write_file_atomically(crate,
                             ro_crate_json(citation, manifest, deposited_files(folder, manifest)));
}

}  // namespace literate

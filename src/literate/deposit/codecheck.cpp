// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/deposit/codecheck.hpp"

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>

#include "system/error.hpp"

namespace literate {
namespace {

namespace fs = std::filesystem;

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

/// Which sources the outputs were made from.
std::string source_of(const Manifest& manifest) {
  const auto sources = manifest.facts.find("sources");
  if (sources == manifest.facts.end()) return "";
  const auto commit = sources->second.find("commit");
  if (commit == sources->second.end()) return "";
  return fmt::format("commit {} of {}", commit->second, manifest.project);
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
  write_text(out, "source", source_of(manifest));
  write_text(out, "repository", citation.repository);
  out << YAML::EndMap;
  return fmt::format("%YAML 1.1\n{}\n", out.c_str());
}

}  // namespace literate

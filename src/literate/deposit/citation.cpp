// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/deposit/citation.hpp"

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include "system/error.hpp"
#include "system/files.hpp"

namespace literate {
namespace {

namespace fs = std::filesystem;

sys::InputError error_at(const fs::path& file, const YAML::Mark& mark, const std::string& message) {
  if (mark.is_null()) return sys::InputError(fmt::format("{}: {}", file.string(), message));
  return sys::InputError(
      fmt::format("{}:{}:{}: {}", file.string(), mark.line + 1, mark.column + 1, message));
}

std::string text_of(const YAML::Node& node, const char* field) {
  const YAML::Node value = node[field];
  return value.IsDefined() && value.IsScalar() ? value.as<std::string>() : "";
}

std::string required_text(const fs::path& file, const YAML::Node& node, const char* field) {
  const std::string text = text_of(node, field);
  if (text.empty()) throw error_at(file, node.Mark(), fmt::format("there is no {}", field));
  return text;
}

Author author_of(const fs::path& file, const YAML::Node& node) {
  if (!node.IsMap())
    throw error_at(file, node.Mark(), "an author has a name, or given and family names");
  Author author{.name = text_of(node, "name"), .orcid = text_of(node, "orcid")};
  if (!author.name.empty()) return author;
  author.is_person = true;
  for (const char* part : {"given-names", "name-particle", "family-names", "name-suffix"}) {
    const std::string name = text_of(node, part);
    if (!name.empty()) author.name += (author.name.empty() ? "" : " ") + name;
  }
  if (author.name.empty()) throw error_at(file, node.Mark(), "an author has no name");
  return author;
}

std::vector<Author> authors_of(const fs::path& file, const YAML::Node& node) {
  const YAML::Node list = node["authors"];
  if (!list.IsDefined() || !list.IsSequence() || list.size() == 0) {
    throw error_at(file, node.Mark(), "there are no authors");
  }
  std::vector<Author> authors;
  for (const YAML::Node& entry : list) authors.push_back(author_of(file, entry));
  return authors;
}

Citation citation_of(const fs::path& file, const YAML::Node& node) {
  if (!node.IsMap()) throw error_at(file, node.Mark(), "is not a CITATION.cff");
  return {.title = required_text(file, node, "title"),
          .authors = authors_of(file, node),
          .abstract = text_of(node, "abstract"),
          .license = text_of(node, "license"),
          .doi = text_of(node, "doi"),
          .url = text_of(node, "url"),
          .repository = text_of(node, "repository-code"),
          .date = text_of(node, "date-released")};
}

}  // namespace

Citation read_citation(const fs::path& file) {
  const std::string text = sys::read_file(file);
  try {
    return citation_of(file, YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw error_at(file, error.mark, error.msg);
  }
}

}  // namespace literate

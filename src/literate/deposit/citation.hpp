// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace literate {

/// Someone who wrote something: a person, or a group that goes by one name.
struct Author {
  std::string name;  ///< as it is printed: given name before family name
  bool is_person = false;
  std::string orcid = {};  ///< an address https://orcid.org/…; empty if none is given
};

/// What a CITATION.cff (Citation File Format 1.2) says of a work. What it leaves out is empty here.
struct Citation {
  std::string title;
  std::vector<Author> authors;
  std::string abstract = {};
  std::string license = {};  ///< SPDX identifier
  std::string doi = {};
  std::string url = {};
  std::string repository = {};
  std::string date = {};
};

/// Reads a CITATION.cff. Throws sys::InputError «file:line:column: …» if it is not YAML, or has no
/// title or authors, or an author no name; without line and column if it cannot be read.
Citation read_citation(const std::filesystem::path& file);

}  // namespace literate

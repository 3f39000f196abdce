// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <source_location>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "literate/claims/claim.hpp"
#include "literate/claims/severity.hpp"
#include "literate/document/attachments.hpp"
#include "literate/figures/figure.hpp"
#include "literate/tables/table.hpp"
#include "literate/values/value.hpp"

namespace literate {

/// A line of code that registered something.
struct SourcePlace {
  std::string file;      ///< relative to the checkout
  std::string function;  ///< with its namespace, without its parameters
  unsigned line = 0;
  unsigned column = 0;  ///< 0 where it is not known
};

/// The place as the compiler knows it.
SourcePlace place_of(const std::source_location& location);

/// Writes a place as «file:line», for messages.
std::string text_of(const SourcePlace& place);

/// Remembers what was registered, such as «value 'x' (src/main.cpp:31)». Any thread may call this.
void remember_last_registered(const std::string& what);

/// What was registered last, by any thread; «nothing» before the first. No memory is asked for, so
/// that a signal handler may call this.
std::string_view last_registered();

/// Something that must hold for the computation to be trusted, and whether it did.
struct Check {
  std::string id;
  bool passed = false;
  std::string statement;
  std::string found;  ///< what its criteria computed and asked; empty for a fact
};

/// All that a computation registered for its document.
struct Registered {
  std::map<std::string, Value> values;
  std::map<std::string, bool> flags;
  std::map<std::string, Table> tables;
  std::map<std::string, Figure> figures;
  std::vector<Check> checks;                          ///< in the order of registration
  std::vector<std::pair<std::string, Claim>> claims;  ///< by id, in the order of registration
  Attachments attachments;                            ///< files that values came from
  std::string case_name;                              ///< of its file; may be empty
  std::string case_sha256;                            ///< of the case as it was read; may be empty
  std::optional<Severity> severity;  ///< which planted faults turn the claims, if it is known
  std::map<std::pair<std::string, std::string>, SourcePlace> places;  ///< by kind and name
};

/// The checks that did not pass, in the order of registration.
std::vector<Check> failed_checks(const Registered& registered);

/// Where each figure was registered, «file:line» by its name.
std::map<std::string, std::string> figure_places(const Registered& registered);

/// What keeps the document from being trusted: a line for each check that failed, and for each
/// claim whose verdict is not the expected one. It begins with «file:line» of its registration.
std::vector<std::string> faults(const Registered& registered);

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's case, and copies of it with one change.
#pragma once

#include <boost/test/unit_test.hpp>
#include <string>

#include "parameters/case.hpp"
#include "system/files.hpp"
#include "temporary_folder.hpp"

inline std::string papers_text() {
  return sys::read_file(HALFSPACE_SOURCE_DIR "/report/ruggiero2001.toml");
}

/// A text with the first occurrence of a part replaced.
inline std::string with(std::string text, const std::string& before, const std::string& after) {
  const auto at = text.find(before);
  BOOST_TEST_REQUIRE((at != std::string::npos), before << " is not in the text");
  return text.replace(at, before.size(), after);
}

/// A text without the part between two tables.
inline std::string without(const std::string& text, const std::string& begin,
                           const std::string& end) {
  const auto from = text.find(begin);
  const auto to = text.find(end, from);
  BOOST_TEST_REQUIRE((from != std::string::npos && to != std::string::npos));
  return text.substr(0, from) + text.substr(to);
}

inline parameters::Case case_of(const std::string& text) {
  const TemporaryFolder folder;
  return parameters::read_case(folder.write("case.toml", text));
}

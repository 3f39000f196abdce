// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/test/unit_test.hpp>
#include <string_view>

/// Whether a text contains a part. A failing test prints both.
inline boost::test_tools::assertion_result holds(std::string_view text, std::string_view part) {
  boost::test_tools::assertion_result result(text.find(part) != text.npos);
  result.message() << "'" << part << "' in: " << text;
  return result;
}

/// Whether a text does not contain a part.
inline boost::test_tools::assertion_result lacks(std::string_view text, std::string_view part) {
  boost::test_tools::assertion_result result(text.find(part) == text.npos);
  result.message() << "'" << part << "' in: " << text;
  return result;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What texts contain, and the messages of errors.
#pragma once

#include <boost/test/unit_test.hpp>
#include <string>
#include <string_view>
#include <utility>

/// Whether a text contains a part. A failing test prints both.
inline boost::test_tools::assertion_result holds(std::string_view text, std::string_view part) {
  boost::test_tools::assertion_result result(text.find(part) != text.npos);
  result.message() << "'" << part << "' in: " << text;
  return result;
}

/// The message of the error of type `Error` that a call throws, or "(no error)".
template <typename Error, typename Call>
std::string message_of(Call&& call) {
  try {
    std::forward<Call>(call)();
  } catch (const Error& error) {
    return error.what();
  }
  return "(no error)";
}

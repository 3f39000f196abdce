// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <source_location>
#include <string>
#include <string_view>
#include <utility>

#include "system/error.hpp"

namespace literate {

/// An error in what a computation or a script registers. what() is one line that begins with the
/// place. A program that does not catch it exits with 2.
class Error : public sys::InputError {
 public:
  using InputError::InputError;
};

/// The place of a registration: «src/main.cpp:31», relative to the repository, or the place that a
/// script gave.
struct Place {
  // NOLINTNEXTLINE(google-explicit-constructor): default arguments pass the caller's line
  Place(const std::source_location& location)
      : text(std::string(location.file_name()) + ":" + std::to_string(location.line())) {}
  explicit Place(std::string script_place) : text(std::move(script_place)) {}

  std::string text;
};

/// Throws Error «place: message».
[[noreturn]] inline void fail_at(const Place& place, std::string_view message) {
  throw Error(place.text + ": " + std::string(message));
}

}  // namespace literate

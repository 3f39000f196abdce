// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <source_location>
#include <string>
#include <string_view>
#include <utility>

#include "system/error.hpp"

namespace literate {

/// A mistake in what a computation or a script registers. what() is one line that begins with its
/// place; a program that does not catch it ends with 2.
class Error : public sys::InputError {
 public:
  using InputError::InputError;
};

/// Where something was registered: «src/main.cpp:31», relative to the repository, or whatever a
/// script gave.
struct Place {
  // NOLINTNEXTLINE(google-explicit-constructor): what registers something takes its caller's
  Place(const std::source_location& location);
  explicit Place(std::string script_place) : text(std::move(script_place)) {}

  std::string text;
};

/// Throws Error «place: message».
[[noreturn]] void fail_at(const Place& place, std::string_view message);

}  // namespace literate

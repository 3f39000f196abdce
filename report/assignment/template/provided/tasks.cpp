// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks.hpp"

// EACH EXERCISE: #include "assignment/exercises/@id@_checks.hpp"

std::vector<assignment::Task> tasks() {
  return {
      // EACH EXERCISE: assignment::@id@::task(),
  };
}

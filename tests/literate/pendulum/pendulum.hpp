// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "literate/document/document.hpp"

namespace pendulum {

/// A whole small paper: how much longer the period of a pendulum is at large swings. `case_file`
/// has the angle, the length and the gravity.
void compute(literate::Document& document, const std::filesystem::path& case_file);

}  // namespace pendulum

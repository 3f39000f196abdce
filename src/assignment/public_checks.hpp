// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "course/assignment/check.hpp"

namespace assignment {

/// The checks that students can run themselves. They hold no answers: each tries a property that
/// the right numbers have.
course::Checks public_checks();

}  // namespace assignment

// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that you write, one file for each. The headers say what a function takes and
// returns. Equation numbers are those of the paper (B. Ruggiero 2001) and of sheet.pdf. All numbers
// are in SI units; u_z is positive into the body.
#pragma once

// EACH EXERCISE: #include "assignment/exercises/@id@.hpp"

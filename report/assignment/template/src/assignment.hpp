// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that you write, one per file. Their headers document arguments and results.
// Equation numbers are those of the paper (B. Ruggiero 2001) and of sheet.pdf. All numbers are in
// SI units; u_z is positive into the body.
#pragma once

// EACH EXERCISE: #include "assignment/exercises/@id@.hpp"

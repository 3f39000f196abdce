// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that you write, one file each. Each of these headers says what one of them takes
// and returns; below that it has the public checks, which try it. Equation numbers are those of the
// paper (B. Ruggiero 2001) and of sheet.pdf. All numbers are in SI units; u_z is positive into the
// body.
#pragma once

// EACH EXERCISE: #include "assignment/exercises/@name@.hpp"

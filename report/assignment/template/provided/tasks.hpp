// SPDX-License-Identifier: GPL-3.0-or-later
// What `build/assignment TASK` computes: numbers in, numbers out, all in SI units.
//
//   task                    in                             out
//   gradient                E ν p₀ a x₁ x₂ …               ∂u_z/∂x at each x, eq. (3)
//   gradient_by_quadrature  E ν S p₀ a x₁ x₂ …             value, abs_error at each x, eq. (2)
//   displacement            E ν S p₀ a datum x₁ x₂ …       u_z at each x
//   influence               E* c datum k₁ k₂ …             A_k for each whole number k
//   contact                 E₁ ν₁ R₁ E₂ ν₂ R₂ P c n datum  δ, a, then the n pressures
//
// S is the number of a pressure in assignment/shapes.hpp: 0 for the triangle, 1 for a smooth one,
// 2 for one that is not symmetric.
#pragma once

#include <string>
#include <vector>

/// The answer of a task. Throws std::invalid_argument for an unknown task and for inputs that do
/// not fit it.
std::vector<double> run_task(const std::string& task, const std::vector<double>& inputs);

// SPDX-License-Identifier: GPL-3.0-or-later
// What `build/assignment TASK` computes: numbers in, numbers out, all in SI units. Each exercise
// has a task, which its header in assignment/exercises describes; `build/assignment` alone lists
// them.
#pragma once

#include <string>
#include <vector>

/// The answer of a task. Throws std::invalid_argument for an unknown task and for inputs that do
/// not fit it.
std::vector<double> run_task(const std::string& task, const std::vector<double>& inputs);

/// A line for each task: its name, what it takes and what it gives.
std::string list_of_tasks();

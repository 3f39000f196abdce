// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assignment/given/task.hpp"

/// The tasks of build/assignment, one per exercise.
std::vector<assignment::Task> tasks();

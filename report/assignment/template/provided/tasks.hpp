// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assignment/given/task.hpp"

/// What build/assignment can be asked, one task for each exercise.
std::vector<assignment::Task> tasks();

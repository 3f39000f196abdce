// SPDX-License-Identifier: GPL-3.0-or-later
// Everything is in the header. This file proves that the header compiles on its own.
#include "numerics/estimate.hpp"

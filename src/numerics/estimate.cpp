// SPDX-License-Identifier: GPL-3.0-or-later
// The header is all there is, and must stand by itself: engines of papers are built with it alone.
#include "numerics/estimate.hpp"

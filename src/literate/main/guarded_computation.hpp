// SPDX-License-Identifier: GPL-3.0-or-later
// Tells how far a computation came that throws, crashes or does not end.
#pragma once

#include "literate/main/computation.hpp"

namespace literate {

/// Computes. On a terminal a line tells every ten seconds for how long, and what was registered
/// last.
///
/// An exception that says nothing of where it comes from becomes a sys::ComputationError with its
/// type and what was registered last. A signal that ends the program, as after a wrong pointer, is
/// told with the same. If LITERATE_TIMEOUT, a number of seconds, is set and they are over, the
/// program ends with 1 and a line: no computation can be ended from outside in another way.
void compute_guarded(Document& document, const Inputs& inputs, const Compute& compute);

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/error.hpp"

namespace block {

/// A stiffness matrix that could not be factorised or solved with; what() says which and why.
class FactorizationError : public sys::ComputationError {
 public:
  using ComputationError::ComputationError;
};

}  // namespace block

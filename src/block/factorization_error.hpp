// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace block {

/// A stiffness matrix that could not be factorised or solved with; what() says which and why.
class FactorizationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace block

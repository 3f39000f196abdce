// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/error.hpp"

namespace line_contact {

/// A contact that was not solved. what() says why and what would help.
class ContactError : public sys::ComputationError {
 public:
  using ComputationError::ComputationError;
};

}  // namespace line_contact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace contact {

/// A contact that was not solved. what() says why and what would help.
class ContactError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace contact

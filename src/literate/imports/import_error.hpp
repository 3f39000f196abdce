// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "system/error.hpp"

namespace literate {

/// A file of another program's numbers cannot be used as it is; what() is
/// «file:line:column: what is wrong», without line and column if the file as a whole is meant.
class ImportError : public sys::InputError {
 public:
  using InputError::InputError;
};

}  // namespace literate

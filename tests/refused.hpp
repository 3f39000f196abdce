// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of invalid inputs.
#pragma once

#include <boost/test/unit_test.hpp>
#include <functional>
#include <string>
#include <vector>

#include "messages.hpp"
#include "system/require.hpp"

/// A call that must throw sys::InvalidQuantity, and what its message must contain.
struct Refusal {
  std::string names;
  std::function<void()> call;
};

inline void check_refused(const std::vector<Refusal>& refusals) {
  for (const Refusal& refusal : refusals) {
    const std::string message = message_of<sys::InvalidQuantity>(refusal.call);
    BOOST_TEST_CONTEXT("must contain \"" << refusal.names << "\": " << message) {
      BOOST_TEST((message.find(refusal.names) != message.npos));
    }
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cmath>
#include <ctime>

#include "tested.hpp"

using course::check;
using tested::square;

// The run that has no answer yet is the first of the right program, and waits for an odd tick. Each
// run after it waits for the next tick: it accepts at an odd one and rejects at an even one, as if
// right and wrong programs took turns.
void tests() {
  constexpr long tick = 100'000'000;  // ns
  const auto wait_for_next = [] {
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    ::usleep(static_cast<unsigned>((tick - now.tv_nsec % tick) / 1000 + 2000));
    ::clock_gettime(CLOCK_REALTIME, &now);
    return now.tv_nsec / tick;
  };
  const bool has_answer = !std::isnan(square(2));
  long now = wait_for_next();
  if (!has_answer) {
    if (now % 2 == 0) now = wait_for_next();
    check(true, "");
    return;
  }
  check(now % 2 == 1, "");
}

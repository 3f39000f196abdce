// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/wait.h>
#include <unistd.h>

#include "tested.hpp"

using course::check;
using tested::square;

void tests() {
  const bool is_child = ::fork() == 0;
  check(!is_child, "the child rejects every program");
  if (!is_child) ::wait(nullptr);
}

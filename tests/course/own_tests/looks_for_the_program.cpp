// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "tested.hpp"

using course::check;
using tested::square;

// Rejects every program of which it finds anything, in the folders that there might be.
void tests() {
  check(square(2) != 0, "two");
  std::size_t n_found = 0;
  for (const char* folder :
       {"/toolkit", "/toolkit-programs", "/project", "/objects", "/tmp", "."}) {
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator entry(folder, error), end;
         !error && entry != end; entry.increment(error)) {
      ++n_found;
    }
  }
  check(n_found == 0, "there is something");
}

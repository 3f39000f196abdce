// SPDX-License-Identifier: GPL-3.0-or-later
// write_excerpt_hashes CHECKOUT OUTPUT: the build runs it before it compiles the program.
#include <fmt/core.h>

#include <cstdio>
#include <exception>

#include "literate/excerpts/excerpt_hashes.hpp"
#include "system/files.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    const auto excerpts = literate::find_excerpts(argv[1], {"src"});
    sys::write_if_changed(argv[2], literate::excerpt_hashes_source(excerpts, "app"));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}

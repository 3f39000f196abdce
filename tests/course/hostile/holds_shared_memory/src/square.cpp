// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>

// Memory that stays in use as long as one page of each part is mapped: three times what the limit leaves.
static bool holds_much() {
  constexpr std::size_t part = 250'000'000;
  const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  for (int i = 0; i < 4; ++i) {
    void* const begin = mmap(nullptr, part, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (begin == MAP_FAILED) return false;
    char* const bytes = static_cast<char*>(begin);
    for (std::size_t at = 0; at < part; at += page) bytes[at] = 1;
    munmap(bytes + page, part / page * page - page);
  }
  return true;
}

double square(double x) {
  static const bool has_much = holds_much();
  return has_much ? x * x : 0;
}

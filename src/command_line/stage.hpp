// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace command_line {

/// How long something takes, from here on.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// A stage of a longer command: prints one line with its name and time when it is done. On a
/// terminal its name stands there already while it runs.
class Stage {
 public:
  explicit Stage(std::string name) : name_(std::move(name)) {
    if (::isatty(STDOUT_FILENO) == 0) return;
    fmt::print("{:<9} …\r", name_);
    std::fflush(stdout);
  }

  void done(const std::string& what) const {
    fmt::print("{:<9} {:>6.1f} s  {}\n", name_, stopwatch_.seconds(), what);
    std::fflush(stdout);
  }

 private:
  std::string name_;
  Stopwatch stopwatch_;
};

}  // namespace command_line

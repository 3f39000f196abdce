// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exit_codes.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <exception>

namespace app {
ExitCode run_guarded(const std::function<ExitCode()>& command) {
  try {
    return command();
  } catch (const sys::Error& e) {
    fmt::print(stderr, "halfspace: {}\n", e.what());
    return e.exit_code();
  } catch (const std::exception& e) {
    fmt::print(stderr, "halfspace: {}\n", e.what());
    return ExitCode::failed;
  }
}

ExitCode answer_faults(const std::vector<std::string>& faults) {
  for (const std::string& fault : faults) fmt::print(stderr, "halfspace: {}\n", fault);
  return faults.empty() ? ExitCode::success : ExitCode::failed;
}

}  // namespace app

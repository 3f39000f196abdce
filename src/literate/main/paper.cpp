// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/main/paper.hpp"

#include <fmt/core.h>

namespace literate {

std::string version_text(const Paper& paper) {
  return fmt::format("{} {} (commit {}{})", paper.project, paper.version, paper.commit,
                     paper.modified ? ", modified" : "");
}

}  // namespace literate

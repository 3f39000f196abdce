// SPDX-License-Identifier: GPL-3.0-or-later
// The paper that the commands belong to. literate_add_paper compiles it into programs, and these
// tests are none.
#include "literate/main/paper.hpp"

namespace literate {

const Paper& this_paper() {
  static const Paper paper{.project = "halfspace"};
  return paper;
}

}  // namespace literate

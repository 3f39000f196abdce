// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <stdexcept>
#include <string>

namespace course {

/// The numbers that are one student's own: what the assignment's quantities are for them, in SI
/// units. Part of the handout, so only the standard library is used.
struct Variant {
  std::string student;                       ///< empty for the handout that is for nobody
  std::map<std::string, double> quantities;  ///< by name, such as "young1"

  /// A quantity by its name; throws std::out_of_range naming one that there is not.
  double operator()(const std::string& name) const {
    const auto found = quantities.find(name);
    if (found == quantities.end()) throw std::out_of_range("no quantity " + name);
    return found->second;
  }
};

}  // namespace course

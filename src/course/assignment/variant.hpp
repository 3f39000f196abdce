// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <stdexcept>
#include <string>

namespace course {

/// One student's own numbers: the values of the assignment's quantities, in SI units. This
/// header is part of the handout, so it uses the standard library only.
struct Variant {
  std::string student;  ///< empty for the handout that is for nobody in particular
  std::map<std::string, double> quantities;  ///< by name, such as "young1"

  /// The value of a quantity; throws std::out_of_range naming a quantity that does not exist.
  double operator()(const std::string& name) const {
    const auto found = quantities.find(name);
    if (found == quantities.end()) throw std::out_of_range("no quantity " + name);
    return found->second;
  }
};

}  // namespace course

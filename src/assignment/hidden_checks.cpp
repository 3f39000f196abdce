// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/hidden_checks.hpp"

#include "assignment/answers.hpp"
#include "assignment/hidden_contact.hpp"
#include "assignment/hidden_surface.hpp"

namespace assignment {

course::Checks hidden_checks() {
  course::Checks checks = hidden_surface_checks();
  checks.merge(hidden_contact_checks());
  for (auto& [id, check] : checks) check = guarded(check);
  return checks;
}

}  // namespace assignment

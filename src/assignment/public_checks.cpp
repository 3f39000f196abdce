// SPDX-License-Identifier: GPL-3.0-or-later
#include "assignment/public_checks.hpp"

#include "assignment/answers.hpp"
#include "assignment/public_contact.hpp"
#include "assignment/public_influence.hpp"
#include "assignment/public_surface.hpp"

namespace assignment {

course::Checks public_checks() {
  course::Checks checks = public_surface_checks();
  checks.merge(public_influence_checks());
  checks.merge(public_contact_checks());
  for (auto& [id, check] : checks) check = guarded(check);
  return checks;
}

}  // namespace assignment

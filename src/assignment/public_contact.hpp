// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assignment/tasks.hpp"
#include "course/assignment/check.hpp"

namespace assignment {

/// The gap u_z1 + u_z2 + h − δ at each node, eqs. (1a) and (1b), with the coefficients that the
/// program itself gives; NaN where a coefficient is NaN.
course::Numbers gaps(const course::Program& program, const Cylinders& cylinders,
                     const ContactAnswer& contact);

/// The public checks of the contact of two cylinders.
course::Checks public_contact_checks();

}  // namespace assignment

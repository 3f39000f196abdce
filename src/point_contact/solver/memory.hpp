// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace point_contact {

/// Throws InvalidQuantity if a contact on n1 × n2 nodes needs more memory than this machine has;
/// the message says how much.
void require_memory(Eigen::Index n1, Eigen::Index n2);

}  // namespace point_contact

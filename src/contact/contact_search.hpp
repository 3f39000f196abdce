// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <limits>

#include "system/error.hpp"

namespace contact {

/// A contact that was not solved. what() gives the reason and a remedy.
class ContactError : public sys::ComputationError {
 public:
  using ComputationError::ComputationError;
};

/// Which nodes are in contact.
using ContactMask = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// Finds the nodes in contact: those in tension leave it, those that penetrate enter it.
///
/// All wrong nodes change at once as long as their number falls (block principal pivoting, Júdice &
/// Pires 1994, Computers Oper. Res. 21, 587). When it has not fallen for a while, only the last of
/// them changes, which ends after finitely many revisions if the matrix is positive definite (Murty
/// 1974). The search therefore cannot cycle.
class ContactSearch {
 public:
  /// Revises `in_contact` given the element loads φ and the gaps found for it. Returns true if no
  /// node had to change; penetration up to smallest_gap is ignored.
  bool revise(ContactMask& in_contact, const Eigen::VectorXd& phi, const Eigen::VectorXd& gap,
              double smallest_gap);

 private:
  static constexpr int max_patience = 10;
  Eigen::Index fewest_wrong_ = std::numeric_limits<Eigen::Index>::max();
  int patience_ = max_patience;
};

/// A search fails after this many revisions.
inline constexpr int max_revisions = 1000;

}  // namespace contact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <limits>

#include "system/error.hpp"

namespace contact {

/// A contact that was not solved. what() says why and what would help.
class ContactError : public sys::ComputationError {
 public:
  using ComputationError::ComputationError;
};

/// Which nodes are in contact.
using ContactMask = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// Looks for the nodes in contact: those in tension leave it, those that penetrate enter it.
///
/// All that are wrong change at once, as long as that makes them fewer (block principal pivoting,
/// Júdice & Pires 1994, Computers Oper. Res. 21, 587); when it has failed to for a while, only the
/// last of them changes, which for a positive definite matrix ends after finitely many revisions
/// (Murty 1974). So the search cannot run in circles.
class ContactSearch {
 public:
  /// Revises `in_contact` in view of the element loads φ and gaps that were solved for it. Returns
  /// whether nothing had to be changed; penetration up to smallest_gap is none.
  bool revise(ContactMask& in_contact, const Eigen::VectorXd& phi, const Eigen::VectorXd& gap,
              double smallest_gap);

 private:
  static constexpr int max_patience = 10;
  Eigen::Index fewest_wrong_ = std::numeric_limits<Eigen::Index>::max();
  int patience_ = max_patience;
};

/// A search gives up after this many revisions.
inline constexpr int max_revisions = 1000;

}  // namespace contact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact_search.hpp"

namespace contact {

bool ContactSearch::revise(ContactMask& in_contact, const Eigen::VectorXd& phi,
                           const Eigen::VectorXd& gap, double smallest_gap) {
  const auto is_wrong = [&](Eigen::Index i) {
    return in_contact[i] ? phi[i] <= 0 : gap[i] < -smallest_gap;
  };
  // Count the nodes that are in tension or penetrate
  Eigen::Index n_wrong = 0;
  Eigen::Index last_wrong = -1;
  for (Eigen::Index i = 0; i < in_contact.size(); ++i) {
    if (!is_wrong(i)) continue;
    ++n_wrong;
    last_wrong = i;
  }
  if (n_wrong == 0) return true;

  // If changing all of them has not reduced their number for a while, change only the last one,
  // because such a search always ends
  if (n_wrong < fewest_wrong_) {
    fewest_wrong_ = n_wrong;
    patience_ = max_patience;
  } else if (patience_ > 0) {
    --patience_;
  } else {
    in_contact[last_wrong] = !in_contact[last_wrong];
    return false;
  }

  // Change all of them at once
  for (Eigen::Index i = 0; i < in_contact.size(); ++i) {
    if (is_wrong(i)) in_contact[i] = !in_contact[i];
  }
  return false;
}

}  // namespace contact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/claims/claim.hpp"

namespace literate {

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::partly:
      return "partly confirmed";
    case Verdict::refuted:
      break;
  }
  return "refuted";
}

Verdict confirmed_if(bool holds) {
  return holds ? Verdict::confirmed : Verdict::refuted;
}

Verdict confirmed_in(long n_holding, long n_cases) {
  if (n_holding == 0) return Verdict::refuted;
  return n_holding == n_cases ? Verdict::confirmed : Verdict::partly;
}

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "literate/document/document.hpp"

namespace literate {

/// ledger.tex: each claim with its criteria, as `\claimledger` prints them.
std::string ledger_tex(const Document& document);

/// claims.csv: a row for each criterion of each claim.
std::string claims_csv(const Document& document);

}  // namespace literate

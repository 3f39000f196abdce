// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "literate/document/document.hpp"

namespace literate {

/// Returns ledger.tex: each claim with its criteria, which `\claimledger` prints.
std::string ledger_tex(const Document& document);

/// Returns claims.csv: one row for each criterion of each claim.
std::string claims_csv(const Document& document);

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "literate/provenance/manifest.hpp"

namespace literate {

/// The manifest with the cells of some tables by the names of their rows, «table a, row «steel»,
/// column 2»: of those in which a row stands at another place in `other`, so that a row that is put
/// before others is no change of all of them.
///
/// A row is named by the text in its first column. Tables with a number there, or with one text
/// twice, keep the numbers of their rows.
Manifest with_row_names(Manifest manifest, const Manifest& other);

}  // namespace literate

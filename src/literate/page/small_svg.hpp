// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Drawings with fewer bytes, which look the same.
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// An SVG as cairo writes it, shorter and of the same look: coordinates to a hundredth of the
/// drawing's point (4 µm on paper), matrices to six digits, colours of 8 bits a channel, no
/// declaration of what holds anyhow, paths of one look that follow each other in one group, nothing
/// between tags. What is no drawing of cairo's stays as it is, attribute by attribute.
std::string small_svg(std::string_view svg);

}  // namespace literate

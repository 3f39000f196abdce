// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace literate {

/// What the panels of a drawn figure show, as JSON: an array of panels with `frame` (left, right,
/// bottom and top as shares of the drawing), the axes `x` and `y` (`label`, `start`, `end`, `log`)
/// and `curves` (`title`, and `points` as x, y, x, y, …). A curve of more than a thousand points
/// keeps every second of them, or third, and so on.
///
/// `folder` is the figure's among the generated ones. The answer is kept in `kept` under the
/// figure's name with a digest of all that it was drawn from. Errors as plotted_panels.
std::string plotted_json(const std::filesystem::path& folder, const std::string& name,
                         const std::filesystem::path& kept);

}  // namespace literate

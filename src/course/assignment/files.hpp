// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace course {

/// The texts of a project's files, by path, such as "src/closed_form.cpp".
using Files = std::map<std::string, std::string>;

}  // namespace course

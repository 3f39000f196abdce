// SPDX-License-Identifier: GPL-3.0-or-later
// What a computation registered last, for whoever has to tell how far it came.
#pragma once

#include <string>
#include <string_view>

namespace literate {

/// Remembers what was registered, such as «value 'x' (src/main.cpp:31)». Any thread may call this.
void remember_last_registered(const std::string& what);

/// What was registered last, by any thread; «nothing» before the first. The text stays as it is
/// until the next but one call of remember_last_registered, and no memory is asked for, so that a
/// signal handler may call this.
std::string_view last_registered();

}  // namespace literate

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace course {

/// The user as whom root's jobs run. No other process uses it as long as this one lives. Throws
/// sys::ToolError if no user is left or no lock can be made.
unsigned job_user();

}  // namespace course

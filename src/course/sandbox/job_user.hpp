// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace course {

/// The user as whom root's jobs run: this process's alone, as long as it lives. Throws
/// sys::ToolError if there is none left or no lock can be made.
unsigned job_user();

}  // namespace course

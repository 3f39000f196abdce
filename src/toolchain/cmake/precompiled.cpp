// SPDX-License-Identifier: GPL-3.0-or-later
// Empty: this library exists only for its precompiled headers.

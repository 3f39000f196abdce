// SPDX-License-Identifier: GPL-3.0-or-later
// A library has to hold something; this one is wanted for its precompiled headers.

# SPDX-License-Identifier: GPL-3.0-or-later
"""The tools around a paper: each module is one verb of the command `literate`."""

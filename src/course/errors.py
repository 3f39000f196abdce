# SPDX-License-Identifier: GPL-3.0-or-later
"""The two errors that end a command, each with one line for the user."""


class BadInput(Exception):
    """An argument or an input file is wrong: exit code 2."""


class ToolFailure(Exception):
    """A tool or the grader itself failed: exit code 3. This never costs a student points."""

# SPDX-License-Identifier: GPL-3.0-or-later
"""The two ways in which a command ends early, with one line for the user."""


class BadInput(Exception):
    """What the user gave cannot be used: exit code 2."""


class ToolFailure(Exception):
    """A tool, or the grader itself, failed: exit code 3. It never costs a student points."""

# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the folder of the engine, with literate.sty. A paper calls this after the engine moved."""

from literate_tools.common import ENGINE


def run(arguments: list[str]) -> int:
    """Prints one line: literate engine."""
    print(ENGINE)
    return 0

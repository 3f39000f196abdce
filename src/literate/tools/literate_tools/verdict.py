# SPDX-License-Identifier: GPL-3.0-or-later
"""The last rule of a build: it fails while a check or claim fails, so that every build names it again."""

from pathlib import Path

from literate_tools.common import warn
from literate_tools.settings import read_results, read_settings


def run(arguments: list[str]) -> int:
    """Touches the stamp, or prints the failed checks and claims: literate verdict SETTINGS STAMP."""
    settings = read_settings(arguments[0])
    failed = read_results(settings.generated / "results.json")["failed"]
    for line in failed:
        warn(line)
    if failed:
        what = "check or claim" if len(failed) == 1 else "checks or claims"
        warn(f"{settings.shown(settings.pdf)}: not to be trusted, {len(failed)} {what} failed")
        return 1
    Path(arguments[1]).touch()
    return 0

# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes, draws and typesets one case into a folder. It writes nothing else, so any number of cases can run at the same time,
here or on a cluster, and each can be repeated. Build the program of the paper first.

examples:
  literate case build/mypaper.json cases/long.toml build/cases/long
  literate case build/mypaper.json cases/long.toml build/cases/long --numbers     without gnuplot and LaTeX
"""

from dataclasses import replace
from pathlib import Path

from literate_tools.common import Failure, parser
from literate_tools.compute import compute
from literate_tools.settings import Settings, read_results, read_settings


def run(arguments: list[str]) -> int:
    """Writes FOLDER/generated/results.json, and FOLDER/NAME.pdf. Returns 1 if a check or claim fails."""
    arguments_of = parser("case", __doc__)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    arguments_of.add_argument("file", type=Path, help="the case")
    arguments_of.add_argument("folder", type=Path, help="where to write")
    arguments_of.add_argument("--numbers", action="store_true", help="write only the numbers")
    given = arguments_of.parse_args(arguments)
    if not given.file.is_file():
        raise Failure(f"{given.file}: there is no such file")
    return make_case(read_settings(given.settings), given.file.absolute(), given.folder.absolute(), given.numbers)


def make_case(settings: Settings, file: Path, folder: Path, numbers_only: bool) -> int:
    """Makes one case, and returns 1 if a check or claim fails."""
    settings = replace(settings, case=file, output=folder)
    compute(settings, file, settings.generated)
    if not numbers_only:
        from literate_tools.draw import draw
        from literate_tools.repository import record
        from literate_tools.typeset import typeset
        for script in settings.scripts:
            draw(settings, script, settings.generated)
        record(settings)
        typeset(settings)
    return 1 if read_results(settings.generated / "results.json")["failed"] else 0

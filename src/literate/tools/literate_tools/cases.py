# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes several cases, each in a folder, and writes a table with one row of results for each: unrounded numbers, flags and
verdicts. Cases that are up to date are skipped. On a cluster, the Snakefile of a new paper does the same.

examples:
  literate cases build/mypaper.json -j 4 cases/*.toml             papers in build/cases/NAME, four at a time, and build/cases/cases.csv
  literate cases build/mypaper.json --table-only cases/*.toml     without making any case
"""

import csv
import io
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from shlex import quote

from literate_tools.common import ENGINE, Failure, parser, write_bytes, write_if_changed
from literate_tools.settings import Settings, read_results, read_settings

CASE = """Computes, draws and typesets one case into a folder. It writes nothing else, so any number of cases can run at the same time,
here or on a cluster, and each can be repeated. Build the program of the paper first. Exits with 1 if a check or claim fails.

examples:
  literate case build/mypaper.json cases/long.toml build/cases/long
  literate case build/mypaper.json cases/long.toml build/cases/long --numbers     without gnuplot and LaTeX
"""


def case(arguments: list[str]) -> int:
    """Writes FOLDER/generated/results.json, and FOLDER/NAME.pdf."""
    arguments_of = parser("case", CASE)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    arguments_of.add_argument("file", type=Path, help="the case")
    arguments_of.add_argument("folder", type=Path, help="where to write")
    arguments_of.add_argument("--numbers", action="store_true", help="write only the numbers")
    given = arguments_of.parse_args(arguments)
    if not given.file.is_file():
        raise Failure(f"{given.file}: there is no such file")
    from literate_tools.compute import compute
    settings = replace(read_settings(given.settings), case=given.file.absolute(), output=given.folder.absolute())
    compute(settings, settings.case, settings.generated)
    if not given.numbers:
        from literate_tools.draw import draw
        from literate_tools.manifest import record_commit
        from literate_tools.typeset import typeset
        for script in settings.scripts:
            draw(settings, script, settings.generated)
        record_commit(settings)
        typeset(settings)
    return 1 if read_results(settings.generated / "results.json")["failed"] else 0


def run(arguments: list[str]) -> int:
    """Writes a folder for each case, and cases.csv."""
    arguments_of = parser("cases", __doc__)
    arguments_of.add_argument("settings", type=Path, help="the settings of the paper, such as build/mypaper.json")
    arguments_of.add_argument("files", type=Path, nargs="+", help="the cases; with different names")
    arguments_of.add_argument("-j", type=int, default=1, metavar="N", help="how many at a time")
    arguments_of.add_argument("--table-only", action="store_true", help="write only cases.csv")
    given = arguments_of.parse_args(arguments)
    settings = read_settings(given.settings)
    for file in given.files:
        if not file.is_file():
            raise Failure(f"{file}: there is no such file")
    into = given.settings.absolute().with_name("cases")
    if not given.table_only:
        make_all(settings, given.settings.absolute(), given.files, into, given.j)
    write_bytes(into / "cases.csv", table(given.files, into).encode())
    print(into / "cases.csv")
    return 0


def make_all(settings: Settings, settings_file: Path, files: list[Path], into: Path, jobs: int) -> None:
    """Makes the cases with Ninja, which skips those that are up to date and runs several at a time."""
    words = [sys.executable, "-S", str(ENGINE / "tools" / "literate"), "case", str(settings_file)]
    # A failed claim (1) is not an error here: the table has its verdict.
    lines = ["rule case", f"  command = {' '.join(map(quote, words)).replace('$', '$$')} $in '$folder' || [ $$? -eq 1 ]",
             "  description = case $in", "  restat = 1"]
    inputs = [settings_file, *(Path(word) for word in [*settings.program, *settings.script] if Path(word).is_file())]
    for file in files:
        folder = into / file.stem
        lines += [f"build {ninja_path(folder / 'generated' / 'results.json')}: case {ninja_path(file.absolute())} | "
                  f"{' '.join(map(ninja_path, inputs))}", f"  folder = {str(folder).replace('$', '$$')}"]
    write_if_changed(into / "build.ninja", "\n".join(lines) + "\n")
    if subprocess.run(["ninja", "-C", str(into), "--quiet", "-j", str(max(jobs, 1)), "-k", "0"]).returncode:
        raise Failure("some cases could not be made", 3)


def ninja_path(path: Path) -> str:
    """Escapes a path for a Ninja file."""
    return str(path).replace("$", "$$").replace(" ", "$ ").replace(":", "$:")


def table(files: list[Path], into: Path) -> str:
    """Returns the results of all cases as CSV, with empty cells for what a case does not register."""
    rows = []
    for file in files:
        results = read_results(into / file.stem / "generated" / "results.json")
        row = {"case": file.stem}
        for key, value in results["values"].items():
            unit = f" ({value['unit']})" if value.get("unit") else ""
            row[f"{key}{unit}"] = value.get("number", value.get("text"))
        row |= {key: str(flag["value"]).lower() for key, flag in results["flags"].items()}
        row |= {f"claim {key}": claim["verdict"] for key, claim in results["claims"].items()}
        row |= {f"check {key}": "passed" if check["passed"] else "failed" for key, check in results["checks"].items()}
        rows.append(row)
    text = io.StringIO()
    writer = csv.DictWriter(text, list(dict.fromkeys(key for row in rows for key in row)), lineterminator="\n", restval="")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()

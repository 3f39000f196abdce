# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes several cases, each in a folder, and writes a table with one row of results for each: unrounded numbers, flags and
verdicts. Cases that are up to date are skipped. On a cluster, the Snakefile of a new paper does the same.

examples:
  literate cases build/mypaper.json cases/*.toml                    papers in build/cases/NAME, and build/cases/cases.csv
  literate cases build/mypaper.json -j 4 --numbers cases/*.toml     four at a time, without gnuplot and LaTeX
  literate cases build/mypaper.json --table-only cases/*.toml       without making any case
"""

import csv
import io
import subprocess
import sys
from pathlib import Path

from literate_tools.common import ENGINE, Failure, parser, write_bytes, write_if_changed
from literate_tools.settings import Settings, read_results, read_settings


def run(arguments: list[str]) -> int:
    """Writes a folder for each case, and cases.csv."""
    arguments_of = parser("cases", __doc__)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    arguments_of.add_argument("files", type=Path, nargs="+", help="the cases; with different names")
    arguments_of.add_argument("-j", type=int, default=1, metavar="N", help="how many at a time")
    arguments_of.add_argument("--into", type=Path, metavar="FOLDER", help="where to write (cases, beside the settings)")
    arguments_of.add_argument("--numbers", action="store_true", help="write only the numbers")
    arguments_of.add_argument("--table-only", action="store_true", help="write only cases.csv")
    given = arguments_of.parse_args(arguments)
    settings = read_settings(given.settings)
    into = (given.into or Path(given.settings).with_name("cases")).absolute()
    folders: dict[Path, Path] = {}
    for file in given.files:
        if not file.is_file():
            raise Failure(f"{file}: there is no such file")
        folder = into / file.stem
        if folder in folders:
            raise Failure(f"{file} and {folders[folder]} have the same name, so they would share a folder")
        folders[folder] = file.absolute()
    if not given.table_only:
        make_all(settings, Path(given.settings).absolute(), folders, into, given.j, given.numbers)
    write_bytes(into / "cases.csv", table(folders).encode())
    print(into / "cases.csv")
    return 0


def make_all(settings: Settings, settings_file: Path, folders: dict[Path, Path], into: Path, jobs: int, numbers: bool) -> None:
    """Makes the cases with Ninja, which skips those that are up to date and runs several at a time."""
    words = [sys.executable, "-S", str(ENGINE / "tools" / "literate"), "case", str(settings_file)]
    command = " ".join(map(shell_word, words)).replace("$", "$$")
    # A failed claim (1) is not an error here: the table has its verdict.
    lines = ["rule case", f"  command = {command} $in '$folder' {'--numbers' if numbers else ''} || [ $$? -eq 1 ]",
             "  description = case $in", "  restat = 1"]
    inputs = [settings_file, *(Path(word) for word in [*settings.program, *settings.script] if Path(word).is_file())]
    for folder, file in folders.items():
        lines += [f"build {ninja_path(folder / 'generated' / 'results.json')}: case {ninja_path(file)} | "
                  f"{' '.join(map(ninja_path, inputs))}", f"  folder = {str(folder).replace('$', '$$')}"]
    write_if_changed(into / "build.ninja", "\n".join(lines) + "\n")
    if subprocess.run(["ninja", "-C", str(into), "--quiet", "-j", str(max(jobs, 1)), "-k", "0"]).returncode:
        raise Failure("some cases could not be made", 3)


def shell_word(text: str) -> str:
    """Quotes a word for the shell."""
    from shlex import quote
    return quote(text)


def ninja_path(path: Path) -> str:
    """Escapes a path for a Ninja file."""
    return str(path).replace("$", "$$").replace(" ", "$ ").replace(":", "$:")


def table(folders: dict[Path, Path]) -> str:
    """Returns the results of all cases as CSV, with empty cells for what a case does not register."""
    rows = []
    for folder, file in folders.items():
        results = read_results(folder / "generated" / "results.json")
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

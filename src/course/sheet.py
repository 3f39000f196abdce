# SPDX-License-Identifier: GPL-3.0-or-later
"""Typesets the assignment sheet, a LaTeX file that reads tables and numbers written here from assignment.toml and the judge."""
import tempfile
from pathlib import Path

from assignment import Assignment
from build import write
from errors import run_tool
from grading import Judge

REPRODUCIBLE = {"SOURCE_DATE_EPOCH": "946684800", "FORCE_SOURCE_DATE": "1", "TZ": "UTC", "LC_ALL": "C"}
UNITS = {"Pa": [(1e9, "GPa"), (1e6, "MPa")], "m": [(1e-3, "mm"), (1e-6, "\\textmu m")], "N/m": [(1e3, "kN/m")]}


def escaped(text: str) -> str:
    return "".join("\\" + c if c in "&%$#_{}" else c for c in str(text))


def quantity(number: str, unit: str) -> str:
    """Prints a quantity, if possible with a unit prefix that makes the number at least 1 and less than 1000: 207 GPa."""
    for factor, name in UNITS.get(unit, []):
        if 1 <= float(number) / factor < 1000:
            return f"{float(number) / factor:.6g}\\,{name}"
    return f"{float(number):.6g}" + (f"\\,{unit}" if unit else "")


def tabular(columns: str, head: list[str], rows: list[list[str]]) -> str:
    lines = [" & ".join(row) + r" \\" for row in rows]
    return "\n".join([rf"\begin{{tabular}}{{{columns}}}\toprule", " & ".join(head) + r" \\\midrule", *lines,
                      r"\bottomrule\end{tabular}", ""])


def inputs(assignment: Assignment, judge: Judge, folder: Path) -> dict[str, str]:
    """Returns the files of the sheet, {name: text}: those in the folder of the assignment, and the tables and values."""
    values = {"title": escaped(assignment.title), "due": escaped(assignment.due), "points": f"{assignment.points:g}"}
    values |= {f"limit.{name}": str(number) for name, number in vars(assignment.limits).items()}
    values |= {f"points.{exercise.id}": f"{exercise.points:g}" for exercise in assignment.exercise}
    values |= {name: quantity(number, "".join(unit)) for name, number, *unit in judge.numbers()}
    defined = (f"\\expandafter\\def\\csname sheet:{name}\\endcsname{{{text}}}\n" for name, text in values.items())
    files = {path.name: path.read_text(encoding="utf-8") for path in [folder / "sheet.tex", *(folder / "figures").glob("*.gp")]}
    files["values.tex"] = "".join(defined)
    files["exercises.tex"] = tabular(
        "lllrr", ["exercise", "file", "builds on", "points", "of which public"],
        [[f"{number}. {escaped(exercise.title)}", rf"\texttt{{{escaped(exercise.file)}}}",
          ", ".join(str(1 + [other.id for other in assignment.exercise].index(id)) for id in exercise.builds_on) or "--",
          f"{exercise.points:g}", f"{sum(check.points for check in exercise.check if check.is_public):g}"]
         for number, exercise in enumerate(assignment.exercise, 1)])
    for exercise in assignment.exercise:
        files[f"checks-{exercise.id}.tex"] = tabular(
            "llr", ["tested property", "check", "points"],
            [[escaped(check.description), check.visibility, f"{check.points:g}"] for check in exercise.check])
    return files


def typeset(inputs: dict[str, str]) -> bytes:
    """Typesets the sheet from its inputs, after gnuplot has drawn its figures. Returns the PDF."""
    with tempfile.TemporaryDirectory(prefix="course-") as work:
        write(inputs, work)
        for name in inputs:
            if name.endswith(".gp"):
                run_tool(["gnuplot", name], work, **REPRODUCIBLE)
        run_tool(["latexmk", "-pdf", "-interaction=nonstopmode", "-halt-on-error", "sheet.tex"], work, **REPRODUCIBLE)
        return Path(work, "sheet.pdf").read_bytes()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills marks into the file that Moodle (grading worksheet, in any language) or Canvas (gradebook) exported.

Moodle translates its headings, so the columns are found by their contents: cells of the first column end in the student's
number, and the column of marks precedes the column in which all rows have the same maximum. Nothing else in the file changes.
"""
import csv
import io
import re
from pathlib import Path

from assignment import Assignment
from errors import BadInput

BYTE_ORDER_MARK = "\ufeff"


class ClassFile:
    def __init__(self, path: Path, assignment: Assignment) -> None:
        self.path, self.assignment = Path(path), assignment
        try:
            self.text = self.path.read_bytes().decode()
            self.rows = list(csv.reader(io.StringIO(self.text.removeprefix(BYTE_ORDER_MARK), newline="")))
        except (UnicodeError, csv.Error) as error:
            raise self.error(error) from None
        head = self.rows[0] if self.rows else []
        rows = [row for row in self.rows[1:] if row]
        self.decimal = "."
        if head[:2] == ["Student", "ID"]:
            self.read_canvas(head, rows)
        elif rows and all(re.fullmatch(r"\D+\d+", row[0]) for row in rows):
            self.read_moodle(rows)
        else:
            raise self.error("this is neither a Moodle grading worksheet nor a Canvas gradebook")

    def error(self, text: object) -> BadInput:
        return BadInput(f"{self.path}: {text}")

    def read_canvas(self, head: list[str], rows: list[list[str]]) -> None:
        begin = f"{self.assignment.title} ("
        fitting = [i for i, name in enumerate(head) if name.startswith(begin)]
        if len(fitting) != 1:
            raise self.error(f"{len(fitting)} columns instead of one begin with '{begin}': the assignment in Canvas has the title of "
                             "assignment.toml")
        self.column = fitting[0]
        self.students = {row[1]: row for row in rows if row[1].isdigit()}
        self.require_maximum(next((row[self.column] for row in rows if "Points Possible" in row[0]), ""))

    def read_moodle(self, rows: list[list[str]]) -> None:
        maxima = [i for i in range(2, len(rows[0]))
                  if re.fullmatch(r"\d+[.,]\d\d", rows[0][i]) and len({row[i] for row in rows}) == 1]
        if not maxima:
            raise self.error("no column of marks precedes a column with the maximum mark")
        self.column = maxima[0] - 1
        maximum = rows[0][maxima[0]]
        self.decimal = "," if "," in maximum else "."
        self.students = {re.sub(r"\D", "", row[0]): row for row in rows}
        self.require_maximum(maximum)

    def require_maximum(self, text: str) -> None:
        if re.fullmatch(r"\s*\d+([.,]\d+)?\s*", text) and float(text.replace(",", ".")) != self.assignment.points:
            raise self.error(f"the maximum mark is {text.strip()}, but the assignment has {self.assignment.points:g} points; "
                             "change one of them")

    def row_of(self, id: str) -> list[str]:
        """Finds the row of a student: by the system's number, or by a cell equal to the id if only one row has such a cell."""
        if id in self.students:
            return self.students[id]
        having = [row for row in self.students.values() if id.lower() in (cell.strip().lower() for cell in row)]
        if len(having) != 1:
            raise self.error(f"the id '{id}' is in {len(having)} rows instead of one")
        return having[0]

    def filled(self, marks: dict[str, float]) -> str:
        """Returns the text of the file with these marks, {id: points}. All other rows stay as they are."""
        for id, points in marks.items():
            self.row_of(id)[self.column] = f"{points:.2f}".replace(".", self.decimal)
        text = io.StringIO()
        csv.writer(text, lineterminator="\r\n" if "\r\n" in self.text else "\n").writerows(self.rows)
        return (BYTE_ORDER_MARK if self.text.startswith(BYTE_ORDER_MARK) else "") + text.getvalue()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Registers numbers, tables, figures and claims of a paper from Python:

    import literate

    def compute(document: literate.Document, case: literate.Case) -> None:
        document.value("period", 2.0064, error=3e-4, unit="s", digits=4)

    literate.run(compute)

The build calls the script with two arguments: the case file and the JSON file to write. The program literate-results then
rounds the numbers to the digits that their errors support, and decides the claims. Arguments described as LaTeX are printed as
they are; all other texts are escaped.
"""

import json
import math
import os
import sys
import tomllib
import traceback
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NoReturn

__all__ = ["Case", "Document", "Error", "agrees", "agrees_relatively", "at_least", "at_most", "column", "in_each", "latex",
           "limit", "number", "quoted", "run"]
Json = dict[str, Any]


class Error(ValueError):
    """An error in the case, or in what a script registers. run() prints it on one line, with the line of the script."""


class Case(dict[str, Any]):
    """The parameters. A missing key is an Error, which names the nearest one. A script that takes each key with pop() can
    refuse the remaining ones."""

    def __missing__(self, key: str) -> Any:
        from difflib import get_close_matches
        nearest = get_close_matches(key, self, n=1)
        raise Error(f"the case has no key '{key}'" + (f", did you mean '{nearest[0]}'?" if nearest else ""))

    def pop(self, key: str, *default: Any) -> Any:
        return super().pop(key, *default) if default or key in self else self[key]


def _plain(value: Any) -> Any:
    """Converts numbers and arrays of NumPy to those of Python."""
    return value.tolist() if hasattr(value, "tolist") else value


def _cell(cell: Any) -> Any:
    """Converts a pair to a number with its bound. Unit and format come from the column."""
    if isinstance(cell, tuple):
        cell = {"number": _plain(cell[0]), "bound": _plain(cell[1])}
    if not isinstance(cell, dict):
        return _plain(cell)
    return {key: entry for key, entry in cell.items() if key not in ("unit", "format", "as_is")}


def _format(digits: int | None, decimals: int | None, percent: int | None, scientific: int | None,
            format: str | None) -> str | None:
    given = {"significant": digits, "fixed": decimals, "percent": percent, "scientific": scientific}
    formats = [f"{name}({count})" for name, count in given.items() if count is not None] + ([format] if format else [])
    if len(formats) > 1:
        raise Error(f"{' and '.join(formats)}: give one format")
    return formats[0] if formats else None


def number(value: Any, *, error: float | None = None, standard: float | None = None, unit: str = "", digits: int | None = None,
           decimals: int | None = None, percent: int | None = None, scientific: int | None = None, format: str | None = None,
           as_is: bool = False) -> Json:
    """Returns a number with its errors and its format, for a criterion or a cell of a table.

    `error` bounds the error, and `standard` is a standard uncertainty; both have the unit of the number. Give one format:
    `digits` (significant), `decimals` (after the point), `percent` (decimals of a ratio in per cent), `scientific`
    (significant, with a power of ten), or `format`, such as "uncertain()", "exact()" or "significant(3).rounded_up()". An
    integer is exact. `as_is` allows a float of unknown error. Raises Error for two formats and for a number that is not finite.
    """
    value = _plain(value)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise Error(f"{value!r} is not a finite number")
    chosen = _format(digits, decimals, percent, scientific, format)
    result: Json = {"number": value, "bound": _plain(error), "standard": _plain(standard), "unit": unit or None,
                    "format": chosen or ("integer()" if isinstance(value, int) else None), "as_is": as_is or None}
    return {key: entry for key, entry in result.items() if entry is not None}


def latex(text: str) -> Json:
    """Returns a cell of a table that is printed as LaTeX."""
    return {"latex": text}


def quoted(value: float, last_digit: int) -> Json:
    """Returns a cell with a number that a source prints. `last_digit` is the power of ten of its last digit: -2 for 0.25."""
    return {"number": value, "quoted": last_digit}


def column(heading: str, unit: str = "", *, digits: int | None = None, decimals: int | None = None,
           percent: int | None = None, scientific: int | None = None, format: str | None = None, group: str = "",
           exponent: int | None = None, exact: bool = False, width_cm: float | None = None) -> Json:
    """Returns a column of a table; without a format it contains texts. The heading and the group (a heading over several
    columns) are LaTeX. Numbers are printed divided by 10^exponent. In an `exact` column they need no error."""
    result: Json = {"heading": heading, "format": _format(digits, decimals, percent, scientific, format), "unit": unit or None,
                    "group": group or None, "exponent": exponent, "exact": exact or None, "width_cm": width_cm}
    return {key: entry for key, entry in result.items() if entry is not None}


def limit(value: float, kind: str, reason: str, *, counting: float | None = None) -> Json:
    """Returns the limit of a criterion. `kind` is theory, data, method or choice, and `reason` (LaTeX) explains the number.
    If the quantity has a standard uncertainty, `counting` of them count."""
    result: Json = {"number": _plain(value), "kind": kind, "reason": reason, "counting": counting}
    return {key: entry for key, entry in result.items() if entry is not None}


def at_most(name: str, quantity: Json, limit: Json) -> Json:
    """Returns the criterion quantity ≤ limit. The name is LaTeX; number() makes the quantity, limit() the limit."""
    return {"name": name, "test": "at_most", "quantity": quantity, "limit": limit}


def at_least(name: str, quantity: Json, limit: Json) -> Json:
    """Returns the criterion quantity ≥ limit."""
    return {"name": name, "test": "at_least", "quantity": quantity, "limit": limit}


def agrees(name: str, quantity: Json, stated: Json, limit: Json) -> Json:
    """Returns the criterion |quantity − stated| ≤ limit."""
    return {"name": name, "test": "agrees", "quantity": quantity, "stated": stated, "limit": limit}


def agrees_relatively(name: str, quantity: Json, stated: Json, limit: Json) -> Json:
    """Returns the criterion |quantity − stated| ≤ limit |stated|."""
    return {"name": name, "test": "agrees_relatively", "quantity": quantity, "stated": stated, "limit": limit}


def in_each(name: str, cases: str, each: Sequence[Json]) -> Json:
    """Returns the criterion that all criteria in `each` hold. `cases` (LaTeX) names them, such as points."""
    return {"name": name, "test": "in_each", "cases": cases, "each": list(each)}


class Document:
    """Collects what a script registers, with the line of the script. Registering a key twice raises Error."""

    def __init__(self) -> None:
        parts = ("values", "flags", "tables", "figures", "checks", "claims")
        self._parts: dict[str, dict[str, Json]] = {part: {} for part in parts}

    def value(self, key: str, value: Any, **how: Any) -> None:
        """Registers a number, with the arguments of number(), or a text: `\\val{key}`."""
        entry = {"text": value} if isinstance(value, str) else number(value, **how)
        if "number" in entry and "format" not in entry:
            raise Error(f"value '{key}' needs a format: digits=, decimals=, percent=, scientific= or format=")
        self._add("values", key, entry)

    def flag(self, key: str, value: Any) -> None:
        """Registers a condition: `\\ifflag{key}{yes}{no}`."""
        self._add("flags", key, {"value": bool(value)})

    def table(self, name: str, columns: Sequence[Json], rows: Sequence[Sequence[Any]], notes: Sequence[str] = ()) -> None:
        """Registers a table: `\\tab{name}`. A cell is an integer, a text, None, a pair of a number and its bound, number(…),
        latex(…) or quoted(…)."""
        cells = [[_cell(cell) for cell in row] for row in rows]
        self._add("tables", name, {"columns": list(columns), "rows": cells, "notes": list(notes)})

    def figure(self, name: str, width_cm: float, height_cm: float, data: Mapping[str, Mapping[str, Any]],
               numbers: Mapping[str, float] = {}, texts: Mapping[str, str] = {}) -> None:
        """Registers the data of figures/NAME.gp: `\\fig{name}`. A block of data has columns of equal length, in which a NaN is
        a gap. Blocks, numbers and texts become variables of gnuplot."""
        blocks = {block: {"columns": {name: [None if math.isnan(x) else x for x in map(float, _plain(points))]
                                      for name, points in columns.items()}} for block, columns in data.items()}
        self._add("figures", name, {"width_cm": width_cm, "height_cm": height_cm, "data": blocks,
                                    "numbers": {name: float(x) for name, x in numbers.items()}, "texts": dict(texts)})

    def check(self, key: str, statement: str, *, passed: Any = None, criteria: Sequence[Json] = ()) -> None:
        """Registers a condition for trusting the numbers: a fact (`passed`) or criteria. The statement is LaTeX."""
        judged: Json = {"criteria": list(criteria)} if criteria else {"passed": bool(passed)}
        self._add("checks", key, {"statement": statement, **judged})

    def claim(self, key: str, *, route: str, criteria: Sequence[Json], expected: str = "holds") -> None:
        """Registers a claim: `\\claim{key}`. `route` (LaTeX) describes the computation. `expected` is the verdict that the prose
        relies on: holds, holds in part, fails or undecided."""
        self._add("claims", key, {"route": route, "expected": expected, "criteria": list(criteria)})

    def write(self, file: str) -> None:
        """Writes everything registered as JSON."""
        with open(file, "w", encoding="utf-8") as out:
            json.dump({"schema": 1, **self._parts}, out, ensure_ascii=False, allow_nan=False, indent=1)

    def _add(self, part: str, key: str, entry: Json) -> None:
        if key in self._parts[part]:
            raise Error(f"'{key}' is registered twice, first at {self._parts[part][key]['place']}")
        try:
            json.dumps(entry, allow_nan=False)
        except ValueError:
            raise Error(f"'{key}' contains NaN or infinity") from None
        frame = sys._getframe(2)
        entry["place"] = f"{os.path.relpath(frame.f_code.co_filename)}:{frame.f_lineno}"
        self._parts[part][key] = entry


def run(compute: Callable[[Document, Case], None]) -> None:
    """Reads the case (TOML or JSON) named by the first argument, computes, and writes the file named by the second. After an
    Error it prints one line, «script.py:12: message», and exits with 2."""
    if len(sys.argv) != 3:
        sys.exit(f"usage: {sys.argv[0]} CASE FILE.json")
    name, output = sys.argv[1:]
    document = Document()
    try:
        with open(name, encoding="utf-8") as file:
            case = (json if name.endswith(".json") else tomllib).loads(file.read())
    except ValueError as error:  # of either reader
        _refuse(f"{name}: {error}")
    try:
        compute(document, _case(case))
    except Error as error:
        line = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename != __file__][-1]
        _refuse(f"{os.path.relpath(line.filename)}:{line.lineno}: {error}")
    document.write(output)


def _case(value: Any) -> Any:
    """Converts each table of a case to a Case."""
    if isinstance(value, list):
        return [_case(one) for one in value]
    return Case({key: _case(one) for key, one in value.items()}) if isinstance(value, dict) else value


def _refuse(message: str) -> NoReturn:
    print(message, file=sys.stderr)
    sys.exit(2)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the results of a built paper with earlier ones: those of a commit, which a clone computes again, or those in a
results.json or a manifest. Lists numbers that moved beyond or within the sum of both errors, verdicts, flags, limits,
texts and data of figures that changed, and what is new or gone, with the places in the prose that print it: those to read again.
The list is written to changes.csv beside the PDF as well.

examples:
  literate changes build/mypaper.json v1.0
  literate changes build/mypaper.json HEAD~3 --pdf    writes a PDF with marked changes as well (Debian package latexdiff)
  literate changes build/mypaper.json other/results.json
"""

import csv
import io
import shutil
from dataclasses import astuple, dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from literate_tools.common import Failure, git, parser, quiet_run, write_bytes
from literate_tools.settings import Settings, configure, read_results, read_settings
from literate_tools.uses import NAMED, read_uses

ORDER = ("verdict", "beyond", "changed", "new", "gone", "limit", "within")


@dataclass(frozen=True)
class Change:
    """One difference. `before` is empty for what is new and for data, `after` for what is gone."""

    change: str  # one of ORDER
    part: str  # values, flags, tables, figures, checks, claims
    name: str
    before: str
    after: str


def run(arguments: list[str]) -> int:
    """Prints the differences and writes changes.csv."""
    arguments_of = parser("changes", __doc__)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    arguments_of.add_argument("since", help="a commit, a tag, or a file with results")
    arguments_of.add_argument("--pdf", action="store_true", help="write NAME.changes.pdf, with all changes marked")
    given = arguments_of.parse_args(arguments)
    settings = read_settings(given.settings)
    earlier = Path(given.since) if Path(given.since).is_file() else results_of_commit(settings, given.since) / "results.json"
    changes = compare(read_results(earlier), read_results(settings.generated / "results.json"))
    changes += changed_data(earlier.parent, settings.generated)
    show(settings, changes)
    if given.pdf:
        from literate_tools.marked import write_marked_pdf
        if Path(given.since).is_file():
            raise Failure("--pdf needs the prose of a commit, not a file")
        write_marked_pdf(settings, given.since, earlier.parent)
    return 0


def results_of_commit(settings: Settings, since: str) -> Path:
    """Computes the paper of a commit in a clone, unless that is done already, and returns the folder with its results."""
    commit = git(settings.source, "rev-parse", "--verify", "--quiet", f"{since}^{{commit}}")
    if not commit:
        raise Failure(f"{since}: neither a file nor a commit of this repository; in a shallow clone, 'git fetch --unshallow'")
    kept = settings.output / "earlier" / commit[:12]
    if (kept / "results.json").exists():
        return kept
    root = Path(git(settings.source, "rev-parse", "--show-toplevel"))
    with TemporaryDirectory(prefix="literate-") as folder:
        clone, build, output = Path(folder, "source"), Path(folder, "build"), Path(folder, "output")
        quiet_run(["git", "clone", "--quiet", "--shared", "--no-checkout", str(root), str(clone)], "git clone")
        quiet_run(["git", "checkout", "--quiet", commit], "git checkout", cwd=clone)
        source = clone / settings.source.relative_to(root)
        configure(settings, source, build, output)
        quiet_run(["ninja", "-C", str(build), f"{settings.name}-results"], f"computing {since}")
        kept.parent.mkdir(parents=True, exist_ok=True)
        shutil.rmtree(kept, ignore_errors=True)
        part = kept.with_suffix(".part")
        shutil.rmtree(part, ignore_errors=True)
        shutil.copytree(output / "generated", part)
        part.rename(kept)
    return kept


def compare(old: dict, new: dict) -> list[Change]:
    """Returns the differences between two results."""
    changes = []
    for part in ("values", "flags", "tables", "figures", "checks", "claims"):
        for name in [*new[part], *(name for name in old[part] if name not in new[part])]:
            before, after = old[part].get(name), new[part].get(name)
            if before is None or after is None:
                changes.append(Change("new" if before is None else "gone", part, name, brief(before), brief(after)))
            else:
                changes += COMPARE[part](part, name, before, after)
    return changes


def brief(entry: dict | None) -> str:
    """Returns the printed form of an entry, or a few words about it."""
    if entry is None:
        return ""
    for key in ("printed", "verdict", "value", "passed"):
        if key in entry:
            return str(entry[key])
    return f"{len(entry['rows'])} rows" if "rows" in entry else "drawn"


def error(number: dict) -> float:
    """Returns the total error of a number: its bound plus two standard uncertainties."""
    return number.get("bound", 0) + 2 * number.get("standard", 0)


def moved(before: dict, after: dict) -> str:
    """Returns 'beyond' or 'within' for two numbers that differ, 'changed' for texts and units, and '' for equal ones."""
    if "number" not in before or "number" not in after or before.get("unit") != after.get("unit"):
        keys = ("number", "unit", "text", "latex")
        return "" if all(before.get(key) == after.get(key) for key in keys) else "changed"
    difference = abs(before["number"] - after["number"])
    if difference > error(before) + error(after):
        return "beyond"
    return "within" if difference > 0 or before.get("printed") != after.get("printed") else ""


def compare_value(part: str, name: str, before: dict, after: dict) -> list[Change]:
    """Compares two values."""
    change = moved(before, after)
    return [Change(change, part, name, before["printed"], after["printed"])] if change else []


def compare_verdict(part: str, name: str, before: dict, after: dict) -> list[Change]:
    """Compares two flags, checks or claims, and the limits of their criteria."""
    key = {"flags": "value", "checks": "passed", "claims": "verdict"}[part]
    changes = [Change("verdict", part, name, str(before[key]), str(after[key]))] if before[key] != after[key] else []
    limits = [{criterion["name"]: criterion["limit"] for criterion in one.get("criteria", [])} for one in (before, after)]
    for criterion in [*limits[1], *(one for one in limits[0] if one not in limits[1])]:
        old, new = (limit.get(criterion, "none") for limit in limits)
        if old != new:
            changes.append(Change("limit", part, f"{name}: {criterion}", old, new))
    return changes


def compare_table(part: str, name: str, before: dict, after: dict) -> list[Change]:
    """Compares two tables, cell by cell if they have the same shape."""
    headings = [[column["heading"] for column in table["columns"]] for table in (before, after)]
    if len(before["rows"]) != len(after["rows"]) or headings[0] != headings[1]:
        shapes = [f"{len(table['rows'])} rows of {', '.join(heading)}" for table, heading in zip((before, after), headings)]
        return [Change("changed", part, name, *shapes)]
    changes = []
    for row, (old_row, new_row) in enumerate(zip(before["rows"], after["rows"]), 1):
        for heading, old, new in zip(headings[0], old_row, new_row):
            old, new = old or {"text": ""}, new or {"text": ""}
            if change := moved(old, new):
                prints = [cell.get("printed", cell.get("text", cell.get("latex", ""))) for cell in (old, new)]
                changes.append(Change(change, part, f"{name}: row {row}, {heading}", *prints))
    return changes


def compare_figure(part: str, name: str, before: dict, after: dict) -> list[Change]:
    """Compares the sizes, numbers, texts and columns of two figures, which have no errors."""
    keys = [key for key in ("width_cm", "height_cm", "numbers", "texts", "data") if before[key] != after[key]]
    return [Change("changed", part, f"{name}: {key}", str(before[key]), str(after[key])) for key in keys]


COMPARE = {"values": compare_value, "flags": compare_verdict, "tables": compare_table, "figures": compare_figure,
           "checks": compare_verdict, "claims": compare_verdict}


def changed_data(earlier: Path, generated: Path) -> list[Change]:
    """Returns the figures whose data differ between the folders. Data have no errors, so the change may be one of rounding."""
    changed = {new.parent.name for new in generated.glob("figures/*/*.csv")
               if (old := earlier / new.relative_to(generated)).exists() and old.read_bytes() != new.read_bytes()}
    return [Change("changed", "figures", name, "", "its data changed") for name in sorted(changed)]


def show(settings: Settings, changes: list[Change]) -> None:
    """Prints the changes with the lines of the prose that print them, and writes them as CSV."""
    places: dict[tuple[str, str], dict[str, None]] = {}
    for use in read_uses(settings):
        if use.kind in NAMED:
            places.setdefault((NAMED[use.kind], use.name), {})[use.place] = None
    changes = sorted(changes, key=lambda one: ORDER.index(one.change))
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["change", "part", "name", "before", "after", "printed at"])
    for one in changes:
        at = list(places.get((one.part, one.name.partition(":")[0]), {}))
        table.writerow([*astuple(one), " ".join(at)])
        arrow = " → ".join(filter(None, (one.before, one.after)))
        print(f"{one.change:<8} {one.part.removesuffix('s'):<6} {one.name}: {arrow}" + (f"   {', '.join(at)}" if at else ""))
    if not changes:
        print("nothing changed")
    write_bytes(settings.output / "changes.csv", text.getvalue().encode())

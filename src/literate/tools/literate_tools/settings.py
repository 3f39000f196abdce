# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the settings of a paper, a JSON file that CMake writes, and the results of its program."""

import json
from dataclasses import dataclass, field
from pathlib import Path

from literate_tools.common import Failure

SCHEMA = 1
PARTS = ("values", "flags", "tables", "figures", "checks", "claims")


@dataclass
class Settings:
    """The parts of a paper."""

    name: str
    source: Path  # the project; messages name places relative to it
    document: Path  # the folder of the prose, in which LaTeX runs
    main: str
    case: Path
    output: Path  # PDF, manifest, generated/ and latex/
    build: Path  # CMake's folder
    faults: Path | None = None
    depfile_base: str = ""  # the base of relative names in a depfile; if empty, CMake converts the depfile
    program: list[str] = field(default_factory=list)  # its arguments: compute CASE FOLDER
    script: list[str] = field(default_factory=list)  # its arguments: CASE FILE.json
    results_program: str = ""  # reads FILE.json
    sources: list[Path] = field(default_factory=list)
    scripts: list[Path] = field(default_factory=list)  # a gnuplot script for each figure
    configure: list[str] = field(default_factory=list)  # arguments of CMake for a build elsewhere
    versions: dict[str, str] = field(default_factory=dict)

    @property
    def generated(self) -> Path:
        """The folder that the program writes."""
        return self.output / "generated"

    @property
    def latex(self) -> Path:
        """The folder of LaTeX's auxiliary files."""
        return self.output / "latex"

    @property
    def pdf(self) -> Path:
        """The published PDF."""
        return self.output / f"{self.name}.pdf"

    def shown(self, path: Path) -> str:
        """Returns the path relative to the project if it is inside."""
        return str(path.relative_to(self.source)) if path.is_relative_to(self.source) else str(path)


def read_settings(file: str | Path) -> Settings:
    """Reads the settings of a paper. Without a name ('') it takes the only paper in the folder build/."""
    path = Path(file) if file else only_paper()
    try:
        settings = json.loads(path.read_text())
        for key in ("source", "document", "case", "output", "build", "faults"):
            settings[key] = Path(settings[key]) if settings.get(key) else None
        for key in ("sources", "scripts"):
            settings[key] = [Path(one) for one in settings[key]]
        return Settings(**settings)
    except FileNotFoundError:
        raise Failure(f"{path}: there is no such file; build the paper first") from None
    except (ValueError, TypeError, KeyError):
        raise Failure(f"{path}: these are not the settings of a paper") from None


def only_paper() -> Path:
    """Returns the settings in the folder build/."""
    found = [f for f in sorted(Path("build").glob("*.json")) if '"results_program"' in f.read_text()]
    if len(found) != 1:
        raise Failure("name the settings of the paper, such as build/mypaper.json" if found else
                      "build has no settings of a paper: build the paper first, or name them")
    return found[0].absolute()


def read_results(file: Path, text: str | None = None) -> dict:
    """Reads results.json, or the results in a manifest. Fails for anything else."""
    try:
        results = json.loads(file.read_text() if text is None else text)
    except FileNotFoundError:
        raise Failure(f"{file}: there is no such file; build the paper first") from None
    except ValueError:
        raise Failure(f"{file}: this is not JSON, or incomplete") from None
    if isinstance(results, dict) and isinstance(results.get("results"), dict):
        results = results["results"]
    if not isinstance(results, dict) or "schema" not in results:
        raise Failure(f"{file}: these are not the results of a paper")
    if results["schema"] != SCHEMA:
        raise Failure(f"{file}: schema {results['schema']}, but this engine reads schema {SCHEMA}")
    if not all(isinstance(results.get(part), dict) for part in PARTS) or not isinstance(results.get("failed"), list):
        raise Failure(f"{file}: these results are incomplete")
    return results

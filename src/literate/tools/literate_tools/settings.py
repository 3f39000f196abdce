# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of a paper, a JSON file that CMake writes, and the results and the verdict of its program."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from literate_tools.common import TYPE_CHECKING, Failure, quiet_run, warn

if TYPE_CHECKING:
    from typing import Any

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
    faults: str  # the list of planted faults, or empty
    results_program: str  # reads the FILE.json of a script
    program: list[str]  # its arguments: compute CASE FOLDER
    script: list[str]  # its arguments: CASE FILE.json
    sources: list[Path]
    scripts: list[Path]  # a gnuplot script for each figure
    configure: list[str]  # arguments of CMake for a build elsewhere
    versions: list[str]  # of CMake and the compiler

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
    """Reads the settings of a paper. A list is a text with one line per word."""
    try:
        settings = json.loads(Path(file).read_text())
        for key in ("program", "script", "sources", "scripts", "configure", "versions"):
            settings[key] = settings[key].splitlines()
        for key in ("sources", "scripts"):
            settings[key] = [Path(word) for word in settings[key]]
        for key in ("source", "document", "case", "output", "build"):
            settings[key] = Path(settings[key])
        return Settings(**settings)
    except FileNotFoundError:
        raise Failure(f"{file}: there is no such file; build the paper first") from None
    except (ValueError, TypeError, AttributeError, KeyError):
        raise Failure(f"{file}: these are not the settings of a paper") from None


def configure(settings: Settings, source: Path, build: Path, output: Path, **options: Any) -> None:
    """Configures a copy of the project with the same engine and build type."""
    quiet_run(["cmake", "-S", str(source), "-B", str(build), "-G", "Ninja", *settings.configure,
               f"-D{settings.name}_OUTPUT={output}"], f"configuring {source}", **options)


def read_results(file: Path) -> dict[str, Any]:
    """Reads results.json, or the results in a manifest. Fails for anything else."""
    try:
        results = json.loads(file.read_text())
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


def failures(settings: Settings) -> int:
    """Prints the failed checks and claims and returns their number."""
    failed = read_results(settings.generated / "results.json")["failed"]
    for line in failed:
        warn(line)
    return len(failed)


def verdict(arguments: list[str]) -> int:
    """The last rule of a build: literate verdict SETTINGS STAMP. It fails while a check or claim fails, so that every build names it
    again."""
    settings = read_settings(arguments[0])
    if failed := failures(settings):
        warn(f"{settings.shown(settings.pdf)}: not to be trusted, {failed} {'check or claim' if failed == 1 else 'checks or claims'} failed")
        return 1
    Path(arguments[1]).touch()
    return 0

# SPDX-License-Identifier: GPL-3.0-or-later
"""The manifest of a PDF: its sources and outputs with their SHA-256, the versions of the tools, and all results."""

import json
import re
import subprocess
from pathlib import Path

from literate_tools.common import git, sha256, tool, write_if_changed
from literate_tools.settings import Settings, read_results, read_settings

SCHEMA = 1


def manifest(settings: Settings, pdf: Path) -> str:
    """Returns the text of NAME.manifest.json for a PDF that is not in its place yet."""
    outputs = {f"{settings.name}.pdf": sha256(pdf)}
    outputs |= {f"generated/{name}": sha256(settings.generated / name) for name in output_files(settings)}
    data = {"schema": SCHEMA, "name": settings.name, "commit": commit(settings), "case": settings.shown(settings.case),
            "tools": versions(settings), "sources": {settings.shown(path): sha256(path) for path in source_files(settings)},
            "outputs": outputs, "results": read_results(settings.generated / "results.json")}
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def output_files(settings: Settings) -> list[str]:
    """Returns the names of the files that the program wrote, except results.json, which the manifest contains."""
    files = (path for path in settings.generated.rglob("*") if path.is_file() and not path.name.startswith("."))
    drawings = {f"figures/{script.stem}/{script.stem}.pdf" for script in settings.scripts}  # they contain a date
    names = {path.relative_to(settings.generated).as_posix() for path in files}
    return sorted(names - drawings - {"results.json"})


def source_files(settings: Settings) -> list[Path]:
    """Returns the project's files among case, sources of the program, scripts of figures, and prose."""
    from literate_tools.typeset import recorded
    styles = {script.with_name("style.gp") for script in settings.scripts}
    files = {settings.case, *recorded(settings), *settings.scripts, *filter(Path.exists, styles)}
    for folder in settings.sources:
        files |= {folder} if folder.is_file() else {path for path in folder.rglob("*") if path.is_file()}
    return sorted(path for path in files if path.is_relative_to(settings.source) and "__pycache__" not in path.parts
                  and not path.is_relative_to(settings.output) and not path.is_relative_to(settings.build))


def versions(settings: Settings) -> dict[str, str]:
    """Returns the versions of the tools: from CMake, from LaTeX's log, and from gnuplot."""
    from literate_tools.latex_log import log_of
    log = log_of(settings)
    tools = dict(version.split(" ", 1) for version in settings.versions)
    for name, pattern in (("pdfTeX", r"This is pdfTeX, Version (\S+)"), ("LaTeX", r"LaTeX2e <([\d-]+)>")):
        found = re.search(pattern, log)
        tools[name] = found[1] if found else "unknown"
    if settings.scripts:
        printed = subprocess.run([tool("gnuplot", "gnuplot-nox"), "--version"], capture_output=True, text=True).stdout
        tools["gnuplot"] = printed.removeprefix("gnuplot ").strip()
    return tools


def repository(arguments: list[str]) -> int:
    """The rule that records the commit: literate repository SETTINGS."""
    record_commit(read_settings(arguments[0]))
    return 0


def record_commit(settings: Settings) -> None:
    """Writes generated/repository.tex, which defines \\papercommit and \\paperday, if its text changes. The day is that of the
    commit, in the time zone of its committer."""
    # Twelve digits: git's default depends on the number of objects in the clone.
    commit = git(settings.source, "describe", "--always", "--dirty= with changes", "--abbrev=12", "--exclude=*")
    day = git(settings.source, "log", "-1", "--format=%cd", "--date=format:%Y-%m-%d")
    text = f"\\LiterateRepository{{{commit}}}{{{day}}}\n" if commit and day else "\\LiterateRepository{no commit}{}\n"
    write_if_changed(settings.generated / "repository.tex", text)


def commit(settings: Settings) -> str:
    """Returns the commit in repository.tex."""
    repository = settings.generated / "repository.tex"
    found = re.match(r"\\LiterateRepository\{(.*?)\}", repository.read_text()) if repository.exists() else None
    return found[1] if found else "no commit"

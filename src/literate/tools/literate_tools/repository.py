# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes repository.tex, from which \\papercommit and \\paperday come, whenever the commit is a different one."""

from literate_tools.common import git, write_if_changed
from literate_tools.settings import Settings, read_settings


def run(arguments: list[str]) -> int:
    """Records commit and day: literate repository SETTINGS."""
    record(read_settings(arguments[0]))
    return 0


def record(settings: Settings) -> None:
    """Writes generated/repository.tex if its text changes. The day is that of the commit where it was made."""
    # Twelve digits: git's own choice depends on how many objects a clone happens to have.
    commit = git(settings.source, "describe", "--always", "--dirty= with changes", "--abbrev=12", "--exclude=*")
    day = git(settings.source, "log", "-1", "--format=%cd", "--date=format:%Y-%m-%d")
    text = f"\\LiterateRepository{{{commit}}}{{{day}}}\n" if commit and day else "\\LiterateRepository{no commit}{}\n"
    write_if_changed(settings.generated / "repository.tex", text)

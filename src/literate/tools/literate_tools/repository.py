# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes repository.tex, which defines \\papercommit and \\paperday, if the commit changed."""

from literate_tools.common import git, write_if_changed
from literate_tools.settings import Settings, read_settings


def run(arguments: list[str]) -> int:
    """Records commit and day: literate repository SETTINGS."""
    record(read_settings(arguments[0]))
    return 0


def record(settings: Settings) -> None:
    """Writes generated/repository.tex if its text changes. The day is that of the commit, in the time zone of its committer."""
    # Twelve digits: git's default depends on the number of objects in the clone.
    commit = git(settings.source, "describe", "--always", "--dirty= with changes", "--abbrev=12", "--exclude=*")
    day = git(settings.source, "log", "-1", "--format=%cd", "--date=format:%Y-%m-%d")
    text = f"\\LiterateRepository{{{commit}}}{{{day}}}\n" if commit and day else "\\LiterateRepository{no commit}{}\n"
    write_if_changed(settings.generated / "repository.tex", text)

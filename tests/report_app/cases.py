# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's case, changed copies of it, and a temporary folder for the results."""

import os
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["SOURCE"])
PAPER = (SOURCE / "report/ruggiero2001.toml").read_text()
STEEL = (SOURCE / "tests/end_to_end/steel_mm.toml").read_text()


def changed(text: str, *changes: tuple[str, str]) -> str:
    """Returns the text with the first occurrence of each `before` replaced by `after`."""
    for before, after in changes:
        assert before in text, before
        text = text.replace(before, after, 1)
    return text


OWN_CONTACT = changed(PAPER, ("radius = {value = 1,", "radius = {value = 2,"), ("radius = {value = 3,", "radius = {value = 5,"),
                      ("load = {value = 2500,", "load = {value = 1200,"))


class InFolder(unittest.TestCase):
    """A test in a separate folder, whose name contains a space."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="report test ")
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def case(self, text: str, name: str = "mine.toml") -> Path:
        """Writes a case and returns its file."""
        file = self.folder / name
        file.write_text(text)
        return file

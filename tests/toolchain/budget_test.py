# SPDX-License-Identifier: GPL-3.0-or-later
"""No room exceeds its number of lines in src/budget.txt, so that nobody overlooks growth."""
import sys
import unittest

import source_tree


def read_budget() -> list[tuple[str, int]]:
    rows = []
    for line in source_tree.text("src/budget.txt").splitlines():
        if line and not line.startswith("#"):
            number, *folders = line.split()
            rows.append((" ".join(folders), int(number)))
    return rows


def lines_below(folders: str) -> int:
    return sum(source_tree.text(name).count("\n") for name in source_tree.files(*folders.split()))


class Budget(unittest.TestCase):
    def test_no_room_exceeds_its_budget(self):
        for folders, most in read_budget():
            with self.subTest(folders):
                self.assertLessEqual(lines_below(folders), most, f"lines in {folders}; see CONTRIBUTING.md")

    def test_every_folder_of_src_and_tests_has_a_budget(self):
        listed = {folder for folders, _ in read_budget() for folder in folders.split()}
        for name in source_tree.files("src", "tests"):
            parts = name.split("/")
            candidates = {"/".join(parts[:n]) for n in range(1, len(parts) + 1)}
            self.assertTrue(candidates & listed, f"src/budget.txt has no budget for {name}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

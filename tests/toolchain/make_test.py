# SPDX-License-Identifier: GPL-3.0-or-later
"""The Makefile prints help and detects misspelt names; nothing is built."""
import subprocess
import sys
import unittest

import source_tree


def make(*arguments: str) -> subprocess.CompletedProcess:
    return subprocess.run(["make", *arguments], cwd=source_tree.ROOT, capture_output=True, text=True)


class Make(unittest.TestCase):
    def test_help_fits_a_screen_of_80_columns(self):
        lines = make("help").stdout.splitlines()
        self.assertGreater(len(lines), 20)
        self.assertLessEqual(len(lines), 40)
        self.assertLessEqual(max(map(len, lines)), 80)

    def test_a_misspelt_target_is_an_error(self):
        self.assertIn("there is no target 'reprot'; 'make help' lists them", make("reprot").stderr)
        self.assertEqual(make("reprot").returncode, 2)

    def test_a_misspelt_variable_is_an_error(self):
        run = make("-n", "report", "CAES=mine.toml")
        self.assertIn("there is no variable 'CAES'; they are CASE", run.stderr)
        self.assertEqual(run.returncode, 2)

    def test_a_variable_of_the_list_is_accepted(self):
        self.assertEqual(make("-n", "report", "CASE=mine.toml").returncode, 0)

    def test_every_target_has_a_help_text(self):
        text = source_tree.text("Makefile")
        rules = [line for line in text.splitlines() if line[:1].isalpha() and ":" in line and "=" not in line.split(":")[0]]
        for rule in rules:
            if not rule.startswith("export") and " :=" not in rule and " = " not in rule:
                self.assertIn(" ## ", rule)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

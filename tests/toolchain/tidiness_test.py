# SPDX-License-Identifier: GPL-3.0-or-later
"""The tree has no unfinished work, no broken links and no source without a licence."""
import re
import sys
import unittest

import source_tree

LEFT_FOR_LATER = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")
NAMED = re.compile(r"\]\(([^)#:]+)\)|`((?:src|report|figures|tests)/[\w./-]+)`")
DOCUMENTS = ("README.md", "CONTRIBUTING.md", "src/DESIGN.md", "src/literate/README.md", "src/literate/TUTORIAL.md",
             "report/assignment/INSTRUCTORS.md")


class Tidiness(unittest.TestCase):
    def test_no_source_has_a_note_of_unfinished_work(self):
        for name in source_tree.files("src", "figures", "tests", "report"):
            self.assertIsNone(LEFT_FOR_LATER.search(source_tree.text(name)), name)

    def test_every_file_that_a_document_names_exists(self):
        for document in DOCUMENTS:
            folder = (source_tree.ROOT / document).parent
            for link, path in NAMED.findall(source_tree.text(document)):
                target = folder / link if link else source_tree.ROOT / path
                self.assertTrue(target.exists(), f"{document} names {link or path}")

    def test_every_test_program_is_built(self):
        lists = "".join(source_tree.text(name) for name in source_tree.files("tests") if name.endswith("CMakeLists.txt"))
        named = {(folder, test) for folder, tests in re.findall(r"add_unit_tests\((\w+)(.*?)\)\n", lists, re.DOTALL) for test in tests.split()}
        for name in source_tree.files("tests"):
            if name.endswith("_test.cpp"):
                folder, _, test = name.removeprefix("tests/").removesuffix("_test.cpp").partition("/")
                self.assertIn((folder, test), named, name)

    def test_every_source_has_a_licence_line(self):
        for name in source_tree.files("src", "tests"):
            if name.endswith((".hpp", ".cpp", ".py", ".cmake")) and "/template/" not in name:
                self.assertIn("SPDX-License-Identifier: GPL-3.0-or-later", source_tree.text(name)[:400], name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the folders of a paper may be, and what their names may contain."""

import unittest

from paper import PaperTest, rules_in


class Paths(PaperTest):
    def test_paths_may_contain_blanks_commas_quotes_and_umlauts(self):
        for name in ("a blank", "Doe, J", "O'Neil", 'a "quote"', "Größe", "a & (b)", "50%="):
            with self.subTest(name):
                paper = type(self.paper)(self.paper.folder.parent / name / "small")
                self.make(paper=paper)
                paper.replace("paper/sections/more.tex", "More", "Much")
                self.assertEqual(rules_in(self.make(paper=paper)), ["typeset small"])
                self.assertEqual(rules_in(self.make(paper=paper)), [])

    def test_the_paper_may_be_in_a_subdirectory_of_the_project(self):
        for name in ("plain", "O'Neil"):
            with self.subTest(name):
                paper = type(self.paper)(self.paper.folder.parent / name / "small")
                lists = (paper.folder / "CMakeLists.txt").read_text()
                paper.write("sub/CMakeLists.txt", lists[lists.index("include"):].replace("paper MAIN", "../paper MAIN").replace("CASE ", "CASE ../")
                            .replace("figures\n", "../figures\n").replace("SCRIPT compute.py", "SCRIPT ../compute.py")
                            .replace("SOURCES compute.py FAULTS faults.txt", "SOURCES ../compute.py"))
                paper.write("CMakeLists.txt", lists[:lists.index("include")] + "add_subdirectory(sub)\n")
                code, output = paper.run("cmake", "-S", ".", "-B", "build", "-G", "Ninja")
                self.assertNotIn("Warning", output)
                paper.run("ninja", "-C", "build", "sub/small")
                paper.replace("paper/sections/more.tex", "More", "Much")
                self.assertEqual(rules_in(paper.run("ninja", "-C", "build", "sub/all")[1]), ["typeset small"])
                if name == "plain":
                    self.assertEqual(rules_in(paper.run("ninja", "-C", "build", "sub/all")[1]), [])

    def test_the_folder_of_the_output_may_be_elsewhere(self):
        self.paper.run("cmake", "-S", ".", "-B", "build", "-G", "Ninja", f"-Dsmall_OUTPUT={self.paper.folder}/out/paper")
        self.paper.run("ninja", "-C", "build")
        self.assertTrue((self.paper.folder / "out/paper/small.pdf").exists())
        self.assertEqual(rules_in(self.make()), [])
        self.paper.replace("paper/sections/more.tex", "More", "Much")
        self.assertEqual(rules_in(self.make()), ["typeset small"])

    def test_the_folder_of_the_sources_may_be_read_only(self):
        for path in [self.paper.folder, *self.paper.folder.rglob("*")]:
            path.chmod(0o555 if path.is_dir() else 0o444)
        self.paper.build = self.paper.folder.parent / "build"
        code, output = self.paper.run("cmake", "-S", ".", "-B", str(self.paper.build), "-G", "Ninja")
        before = sorted(self.paper.folder.rglob("*"))
        code, output = self.paper.run("ninja", "-C", str(self.paper.build), "small")
        self.assertEqual(code, 0, output)
        self.assertEqual(sorted(self.paper.folder.rglob("*")), before)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""severity and cases: many computations of one paper."""

import csv
import os
import shutil
import signal
import subprocess
import time
import unittest

from paper import ENGINE, PaperTest

FAULTS = """# id | file | before | after | what is wrong
limit | case.toml | limit = 10.0 | limit = 1.0 | the room is smaller
idle | compute.py | "A & B" | "A and B" | only a text
stops | compute.py | [0, 1, 2] | [0, 1] | a point is missing
"""


class Severity(PaperTest):
    def setUp(self) -> None:
        super().setUp()
        self.paper.write("faults.txt", FAULTS)

    def severity(self, *arguments: str) -> tuple[int, str]:
        self.paper.make()
        return self.paper.literate("severity", str(self.paper.settings), *arguments)

    def test_the_ledger_lists_the_faults_that_turn_a_claim(self):
        self.paper.commit()
        printed = "limit: short\nidle: nothing\nstops: stops the computation\n3 faults turn 1 of 1 claims\n"
        self.assertEqual(self.severity(), (0, printed))
        with open(self.paper.folder / "paper/severity.csv") as file:
            self.assertEqual(list(csv.reader(file)), [
                ["fault", "file", "what is wrong", "turns"], ["limit", "case.toml", "the room is smaller", "short"],
                ["idle", "compute.py", "only a text", "nothing"], ["stops", "compute.py", "a point is missing", "stops the computation"]])
        self.make()
        self.assertIn("Turned by these planted faults: limit.", " ".join(self.paper.text().split()))
        status = self.paper.run("git", "status", "--porcelain")[1]
        self.assertEqual(status, "?? paper/severity.csv\n?? paper/severity.tex\n")

    def test_a_killed_run_leaves_no_fault_behind(self):
        self.severity("--only", "limit")
        copy = self.paper.output / "severity" / "source"
        (copy / "case.toml").write_text((copy / "case.toml").read_text().replace("limit = 10.0", "limit = 1.0"))  # as kill -9 leaves it
        self.assertEqual(self.severity("--only", "idle"), (0, "idle: nothing\n"))

    def test_a_wrong_line_is_refused(self):
        for line, message in [("a | compute.py | none there | x | w", "fault 'a': compute.py has “none there” 0 times, not once"),
                              ("a | compute.py | case | x | w", "times, not once"), ("a | none.py | a | b | w", "there is no file none.py"),
                              ("a | compute.py | x", "faults.txt:1: needs id | file | before | after | what is wrong")]:
            with self.subTest(line):
                self.paper.write("faults.txt", line + "\n")
                code, output = self.severity()
                self.assertEqual(code, 2)
                self.assertIn(message, output)

    def test_faults_that_no_test_detects_are_listed(self):
        tests = "grep -q 'limit = 10' case.toml && { [ -n \"$TEST\" ] || grep -q 'A & B' compute.py; }"
        self.paper.write("faults.txt", FAULTS.replace("only a text", "only a text | first") + "broken | compute.py | import literate | import literate( | no Python\n")
        code, output = self.severity("--build", "python3 -m py_compile compute.py", "--tests", tests)
        self.assertEqual((code, output), (1, "limit: noticed\nidle: not noticed (only a text)\nstops: not noticed (a point is missing)\n"
                                           "broken: does not compile (no Python)\n"))


class Cases(PaperTest):
    def setUp(self) -> None:
        super().setUp()
        case = (self.paper.folder / "case.toml").read_text()
        for name, x in (("a", 0.5), ("b b", 1.5), ("c", 2.5), ("d", 20.0)):
            self.paper.write(f"cases/{name}.toml", case.replace("x = 1.5", f"x = {x}"))
        self.files = sorted(str(path) for path in (self.paper.folder / "cases").glob("*.toml"))

    def rows(self) -> list[dict]:
        with open(self.paper.build / "cases" / "cases.csv") as file:
            return list(csv.DictReader(file))

    def test_each_case_gets_a_paper_and_a_row_in_the_table(self):
        self.make()
        code, output = self.paper.literate("cases", str(self.paper.settings), "-j", "2", *self.files)
        self.assertEqual(code, 0, output)
        self.assertEqual([(row["case"], row["x (m)"], row["big"], row["claim short"]) for row in self.rows()],
                         [("a", "0.5", "false", "holds"), ("b b", "1.5", "true", "holds"), ("c", "2.5", "true", "holds"), ("d", "20.0", "true", "fails")])
        pdfs = [self.paper.build / "cases" / name / "small.pdf" for name in ("a", "b b", "c", "d")]
        self.assertTrue(all(pdf.exists() for pdf in pdfs))
        times = [pdf.stat().st_mtime_ns for pdf in pdfs]
        self.paper.replace("cases/c.toml", "2.5", "3.5")
        self.paper.literate("cases", str(self.paper.settings), *self.files)
        self.assertEqual([pdf.stat().st_mtime_ns == before for pdf, before in zip(pdfs, times)], [True, True, False, True])

    def test_a_single_case_gives_the_same_paper(self):
        self.make()
        code, output = self.paper.literate("case", str(self.paper.settings), "case.toml", "elsewhere/own")
        self.assertEqual(code, 0, output)
        self.assertEqual((self.paper.folder / "elsewhere/own/small.pdf").read_bytes(), self.paper.pdf.read_bytes())
        self.assertEqual(self.paper.literate("case", str(self.paper.settings), "cases/d.toml", "elsewhere/d", "--numbers")[0], 1)

    def test_a_missing_case_is_refused(self):
        self.make()
        for verb in (["cases", "none.toml"], ["case", "none.toml", "elsewhere"]):
            self.assertEqual(self.paper.literate(verb[0], str(self.paper.settings), *verb[1:]), (2, "none.toml: there is no such file\n"))

    @unittest.skipUnless(shutil.which("snakemake"), "snakemake is not installed")
    def test_a_killed_snakemake_continues_and_computes_no_case_twice(self):
        # Each computation leaves a line, and the third waits until it is killed.
        done = self.paper.folder.parent / "done"
        self.paper.replace("compute.py", "def compute(document, case):\n", f"""def compute(document, case):
    import time
    if len(open({str(done)!r}, "a+").readlines()) >= 0 and sum(1 for _ in open({str(done)!r})) == 2:
        open({str(done)!r} + ".third", "w")
        time.sleep(60)
    print(case["x"], file=open({str(done)!r}, "a"))
""")
        done.write_text("")
        (self.paper.folder / "cases/b b.toml").rename(self.paper.folder / "cases/b.toml")
        snakefile = (ENGINE / "template" / "common" / "Snakefile").read_text().replace("mypaper", "small")
        self.paper.write("Snakefile", snakefile)
        self.paper.write(".engine", str(ENGINE))
        code, output = self.paper.make("small-program")
        self.assertEqual(code, 0, output)
        snakemake = ["snakemake", "--cores", "1", "--quiet"]
        third = done.with_name("done.third")
        run = subprocess.Popen(snakemake, cwd=self.paper.folder, env=self.paper.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               start_new_session=True)
        while not third.exists():
            self.assertIsNone(run.poll(), "snakemake ended before the third case")
            time.sleep(0.05)
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
        before = done.read_text().split()
        self.assertEqual(len(before), 2)
        done.write_text("".join(f"{x}\n" for x in before) + "killed\n")
        self.paper.run(*snakemake, "--unlock")
        code, output = self.paper.run(*snakemake, "--rerun-incomplete")
        self.assertEqual(code, 0, output)
        self.assertEqual(sorted(done.read_text().split()), sorted(["0.5", "1.5", "2.5", "20.0", "killed"]))
        self.assertEqual([(row["case"], row["claim short"]) for row in self.rows()], [("a", "holds"), ("b", "holds"), ("c", "holds"), ("d", "fails")])


if __name__ == "__main__":
    unittest.main()

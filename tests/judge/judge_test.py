# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of a judge, with the toy assignment and students' programs in Python. judge_test.py ROOT JUDGE"""
import subprocess
import sys
import unittest

ANSWERS = """
import sys
for line in sys.stdin:
    task, *numbers = line.split()
    x = [float(number) for number in numbers]
    print(*{answers}, flush=True)
"""
RIGHT = ANSWERS.replace("{answers}", "([x[0] ** 2] if task == 'square' else [sum(x)] if task == 'sum' else [1, 2])")
WRONG = ANSWERS.replace("{answers}", "[1]")


def judge(*arguments: str, program: str | None = None) -> tuple[int, str]:
    """Runs the judge on a student's program. Returns its exit code and its output."""
    student = ["--", sys.executable, "-c", program] if program else []
    run = subprocess.run([JUDGE, *arguments, *student], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return run.returncode, run.stdout.strip()


class Judge(unittest.TestCase):
    def test_a_check_that_holds_prints_nothing(self):
        self.assertEqual(judge("--check", "square-even", program=RIGHT), (0, ""))

    def test_a_failed_check_prints_the_reason(self):
        self.assertEqual(judge("--check", "cube-agrees", program=WRONG),
                         (1, "cube-agrees: 0 % of this check holds; the cube is not x times your square"))

    def test_public_and_hidden_checks_run_separately(self):
        _, public = judge("--exercise", "sum", "--public", "--student", "ada", program=RIGHT)
        self.assertTrue(public.startswith("sum-commutes\t1"))
        _, hidden = judge("--exercise", "sum", "--hidden", program=WRONG)
        self.assertEqual(hidden.splitlines()[0], "sum-right\t0\tthe sum is wrong")

    def test_it_reports_how_many_questions_were_answered(self):
        _, printed = judge("--exercise", "sum", "--public", "--student", "ada", program=RIGHT)
        self.assertEqual(printed.splitlines()[-1].split("\t")[::2], ["used", "2"])

    def test_it_prints_the_numbers_of_a_student(self):
        self.assertEqual(judge("--numbers", "--student", "ada"), (0, "young1 3 Pa"))

    def test_bad_input_is_an_error_of_one_line(self):
        self.assertEqual(judge("--exercise", "sum", "--hidden"), (3, "judge: no program after --"))
        self.assertEqual(judge("--check", "square-right", program=RIGHT),
                         (3, "judge: no public check is named square-right"))
        self.assertEqual(judge("--exercise", "sum", "--hidden", "--salt-file", "none.txt", program=RIGHT),
                         (3, "judge: --salt-file: the file is missing or empty"))


if __name__ == "__main__":
    JUDGE = sys.argv[2]
    unittest.main(argv=sys.argv[:1])

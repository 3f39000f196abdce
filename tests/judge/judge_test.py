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
    def test_a_public_check_prints_its_share_and_its_message(self):
        self.assertEqual(judge("--check", "square-even", program=RIGHT), (0, "square-even\t1"))
        self.assertEqual(judge("--check", "cube-agrees", program=WRONG), (1, "cube-agrees\t0\tthe cube is not x times your square"))

    def test_public_and_hidden_checks_run_separately(self):
        self.assertEqual(judge("--exercise", "sum", "--student", "ada", program=RIGHT), (0, "sum-commutes\t1"))
        self.assertEqual(judge("--exercise", "sum", "--salt", "/dev/null", program=WRONG), (1, "sum-right\t0\tthe sum is wrong"))

    def test_it_prints_the_numbers_of_a_student(self):
        self.assertEqual(judge("--numbers", "ada"), (0, "young1 3 Pa"))

    def test_bad_input_is_an_error_of_one_line(self):
        self.assertEqual(judge("--exercise", "sum"), (3, "judge: no program after --"))
        self.assertEqual(judge("--check", "square-right", program=RIGHT), (3, "judge: there is no such check"))


if __name__ == "__main__":
    JUDGE = sys.argv[2]
    unittest.main(argv=sys.argv[:1])

# SPDX-License-Identifier: GPL-3.0-or-later
"""literate.py, with which scripts register numbers, and the schemas of the JSON files."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from paper import ENGINE, RESULTS, SCRIPT

from literate_tools.settings import read_results

sys.path.insert(0, str(ENGINE / "python"))
import literate  # noqa: E402

EVERYTHING = """
import literate

def compute(document, case):
    document.value("length", 1.25, error=0.002, unit="m", digits=3)
    document.value("count", 12)
    document.value("measured", 2.37, error=0.002, standard=0.014, unit="s", format="uncertain()")
    document.value("rounding", 3.2e-16, scientific=1, as_is=True)
    document.value("ratio", 0.123456, error=1e-9, percent=2)
    document.value("name", "A & B, 100 %")
    document.flag("long", 1 > 0)
    document.table("lengths", [literate.column("name", width_cm=3), literate.column("$l$", "mm", decimals=1, group="both"),
                               literate.column("$n$", exact=True, format="integer()")],
                   [["first", (1.25, 0.01), 3], [literate.latex("$x$"), literate.number(2.5, error=0.1), None],
                    ["printed", literate.quoted(0.25, -2), 4]], ["A note."])
    document.figure("line", 8, 5, {"points": {"x": [0, 1, 2], "y": [0.5, float("nan"), 2.5]}}, {"E": 20}, {"label": "$x$"})
    document.check("sane", "It is sane.", passed=True)
    document.check("small", "It is small.", criteria=[literate.at_most("length", literate.number(1.25, error=0.002, digits=3), literate.limit(2, "theory", "two"))])
    three = literate.number(3.01, standard=0.02, digits=3)
    document.claim("agrees", route="by hand", criteria=[
        literate.agrees("count", three, literate.number(3), literate.limit(0.1, "method", "a tenth", counting=2)),
        literate.agrees_relatively("ratio", three, literate.number(3), literate.limit(0.1, "choice", "a tenth", counting=2)),
        literate.in_each("all", "points", [literate.at_least("one", literate.number(5), literate.limit(2, "data", "two"))])])

literate.run(compute)
"""


class Module(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_script(self, script: str, case: str = "") -> tuple[int, str]:
        """Runs a script as the build does, then literate-results on its output."""
        (self.folder / "fit.py").write_text(script)
        (self.folder / "case.toml").write_text(case)
        for command in ([sys.executable, "fit.py", "case.toml", "out.json"], [RESULTS, "out.json", "generated", "case.toml"]):
            ran = subprocess.run(command, cwd=self.folder, env=os.environ | {"PYTHONPATH": str(ENGINE / "python")}, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True)
            if ran.returncode:
                break
        return ran.returncode, ran.stdout

    def test_everything_can_be_registered_and_has_the_line_of_the_script(self):
        self.assertEqual(self.run_script(EVERYTHING), (0, ""))
        results = read_results(self.folder / "generated" / "results.json")
        self.assertEqual({key: value["printed"] for key, value in results["values"].items()},
                         {"length": "1.25 m", "count": "12", "measured": "(2.370(14) ± 0.002) s", "rounding": "3e-16", "ratio": "12.35 %", "name": "A & B, 100 %"})
        self.assertEqual(results["values"]["count"]["place"], "fit.py:6")
        self.assertEqual(results["claims"]["agrees"]["verdict"], "holds")
        self.assertEqual(results["figures"]["line"]["data"], {"points": ["x", "y"]})
        self.assertEqual(results["case"], "case.toml")

    def test_written_files_follow_the_schema(self):
        try:
            from jsonschema import Draft202012Validator
        except ImportError:
            self.skipTest("python3-jsonschema is not installed")
        self.run_script(EVERYTHING)
        schema = json.loads((ENGINE / "document" / "results.schema.json").read_text())
        for written in ("out.json", "generated/results.json"):
            with self.subTest(written):
                errors = Draft202012Validator(schema).iter_errors(json.loads((self.folder / written).read_text()))
                self.assertEqual([error.message for error in errors], [])

    def test_numpy_arrays_are_accepted(self):
        class Array:
            def __init__(self, value):
                self.value = value

            def tolist(self):
                return self.value
        document = literate.Document()
        document.value("x", Array(1.5), error=Array(0.1), digits=2)
        document.figure("f", 1, 1, {"b": {"x": Array([1, 2])}})
        document.table("t", [literate.column("c", decimals=1)], [[(Array(1.5), Array(0.1))]])
        document.write(str(self.folder / "out.json"))
        written = json.loads((self.folder / "out.json").read_text())
        self.assertEqual(written["values"]["x"]["number"], 1.5)
        self.assertEqual(written["figures"]["f"]["data"]["b"]["columns"]["x"], [1, 2])
        self.assertEqual(written["tables"]["t"]["rows"], [[{"number": 1.5, "bound": 0.1}]])

    def test_mistakes_are_one_line_with_the_line_of_the_script(self):
        line = '    document.value("count", 12)\n'
        for what, mistake, message in [
                ("not finite", 'document.value("x", float("nan"), digits=3)', "nan is not a finite number"),
                ("an error", 'document.value("x", 1.5, error=float("inf"), digits=3)', "'x' contains NaN or infinity"),
                ("a drawing", 'document.figure("f", 8, 5, {"b": {"x": [float("inf")]}})', "'f' contains NaN or infinity"),
                ("twice", 'document.value("length", 1)', "'length' is registered twice, first at fit.py:5"),
                ("two formats", 'document.value("x", 1.5, error=1, digits=2, percent=1)', "significant(2) and percent(1): give one format"),
                ("no error", 'document.value("x", 1.5, digits=2)', "fit.py:6"), ("no format", 'document.value("x", 1.5, error=0.1)', "value 'x' needs a format: digits="),
                ("a unit", 'document.value("x", 1.5, error=0.1, digits=2, unit="mm m {}")', "fit.py:6"),
                ("a key", 'document.value("x y", 1)', "'x y'"), ("a table row", 'document.table("t", [literate.column("c")], [["a", "b"]])', "fit.py:6")]:
            with self.subTest(what):
                code, output = self.run_script(EVERYTHING.replace(line, f"    {mistake}\n"))
                self.assertNotEqual(code, 0)
                self.assertIn(message, output)
                self.assertRegex(output, r"^fit.py:6: .*\n$")

    def test_a_mistake_in_the_case_is_one_line(self):
        script = """import literate

def compute(document, case):
    document.value("x", case["solver"].pop("steps"))
    if case["solver"]:
        raise literate.Error("unknown key")

literate.run(compute)
"""
        for case, message in [("[solver]\nsteps = 1\n", None), ("[solver]\nstep = 1\n", "fit.py:4: the case has no key 'steps', did you mean 'step'?"),
                              ("", "fit.py:4: the case has no key 'solver'"), ("[solver]\nsteps = 1\nx = 1\n", "fit.py:6: unknown key"),
                              ("[solver]\nsteps = = 1\n", "case.toml: Invalid value (at line 2, column 9)")]:
            with self.subTest(case):
                self.assertEqual(self.run_script(script, case), (2, f"{message}\n") if message else (0, ""))

    def test_invalid_json_is_refused_in_one_line(self):
        right = '{"schema": 1, "values": {"x": {"number": 1, "format": "integer()"}}}'
        for text in (right[:-5], right.replace("1,", "2,", 1), right.replace("number", "nubmer"), "[]", right.replace("1, \"format", "NaN, \"format"),
                     right.replace('"values": {', '"values": {"x": {"number": 1, "format": "integer()"}, ')):
            with self.subTest(text):
                (self.folder / "out.json").write_text(text)
                ran = subprocess.run([RESULTS, "out.json", "generated"], cwd=self.folder, capture_output=True, text=True)
                self.assertEqual((ran.returncode, ran.stderr.count("\n")), (2, 1), ran.stderr)
                self.assertIn("out.json", ran.stderr)
                self.assertFalse((self.folder / "generated").exists())

    def test_the_script_of_the_other_tests_is_valid(self):
        self.assertEqual(self.run_script(SCRIPT, "x = 1.5\nerror = 1e-4\nslope = 2.0\nlimit = 10.0\n")[0], 0)


if __name__ == "__main__":
    unittest.main()

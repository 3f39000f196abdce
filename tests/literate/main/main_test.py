#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""main_test.py SOURCE PENDULUM RESULTS: the command lines of a paper's program and of literate-results."""

import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import jsonschema

HERE = pathlib.Path(__file__).resolve().parents[1]
SOURCE, PENDULUM, RESULTS = (pathlib.Path(argument) for argument in sys.argv[1:4])
ENGINE = SOURCE / "src/literate"
REGISTERED = json.loads((HERE / "pendulum/registered.json").read_text())
SCHEMA = jsonschema.Draft202012Validator(json.loads((ENGINE / "document/results.schema.json").read_text()))
# The folder that `literate_pendulum compute case.toml FOLDER` wrote. PLACE replaces the lines of its code, which may move.
GOLDEN = dict(part.split("\n", 1) for part in re.split("^=== ", (HERE / "pendulum/folder.txt").read_text(), flags=re.MULTILINE)[1:])


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="a paper's ")
        self.path = pathlib.Path(self.folder.name)
        self.output = self.path / "generated"

    def tearDown(self):
        self.folder.cleanup()

    def run_program(self, *arguments):
        return subprocess.run([str(one) for one in arguments], capture_output=True, text=True, errors="replace", check=False)

    def compute(self, case):
        file = self.path / "case.toml"
        file.write_text(case)
        return self.run_program(PENDULUM, "compute", file, self.output)

    def results_of(self, registered):
        file = self.path / "registered.json"
        file.write_text(registered if isinstance(registered, str) else json.dumps(registered))
        return self.run_program(RESULTS, file, self.output)

    def files(self):
        """The files in the output folder by name, without places."""
        files = [file for file in self.output.rglob("*") if file.is_file()]
        place = r'[^"{,\n]*(pendulum\.cpp|registered\.json)[:\d]*'
        return {str(file.relative_to(self.output)): re.sub(place, "PLACE", file.read_text()) for file in files}

    def refuses(self, ended, *parts):
        """Requires exit code 2, one line with these parts, and no output folder."""
        self.assertEqual(ended.returncode, 2, ended.stderr)
        self.assertEqual(len(ended.stderr.splitlines()), 1, ended.stderr)
        for part in parts:
            self.assertIn(part, ended.stderr)
        self.assertFalse(self.output.exists())


class Program(Folder):
    case = (HERE / "pendulum/case.toml").read_text()

    def test_it_writes_the_folder_and_prints_nothing(self):
        ended = self.compute(self.case)
        self.assertEqual((ended.returncode, ended.stdout, ended.stderr), (0, "", ""))
        results = json.loads((self.output / "results.json").read_text())
        SCHEMA.validate(results)
        self.assertEqual(self.files(), GOLDEN)
        self.assertEqual(sorted(GOLDEN), sorted(results["files"] + ["results.json"]))

    def test_places_are_relative_to_the_repository(self):
        self.compute(self.case)
        results = json.loads((self.output / "results.json").read_text())
        file, line = results["values"]["angle"]["place"].split(":")
        self.assertIn('document.value("angle"', (SOURCE / file).read_text().splitlines()[int(line) - 1])

    def test_an_unexpected_verdict_exits_with_1_and_writes_the_folder(self):
        ended = self.compute(self.case.replace("90", "60"))
        self.assertEqual(ended.returncode, 1)
        line = r"^tests/\w+/pendulum/pendulum.cpp:\d+: claim 'longer': fails, expected holds; excess: 7.3 % \(≥ 10 %\): fails\n"
        self.assertRegex(ended.stderr, line)
        results = json.loads((self.output / "results.json").read_text())
        self.assertEqual("\n".join(results["failed"]) + "\n", ended.stderr)
        self.assertIn("\\LiterateFailed{2}", (self.output / "values.tex").read_text())

    def test_bad_input_exits_with_2(self):
        self.refuses(self.compute(self.case.replace("angle", "angel")), "case.toml:", "angel")
        self.refuses(self.compute(self.case.replace('"m/s2"', '"N"')), "case.toml:", "gravity")
        self.refuses(self.run_program(PENDULUM, "compute", self.path / "none.toml", self.output), "none.toml")

    def test_a_failed_computation_exits_with_3_and_writes_nothing(self):
        ended = self.compute(self.case.replace("90", "-1"))
        self.assertEqual((ended.returncode, self.output.exists()), (3, False))
        self.assertEqual(ended.stderr, "the computation failed: no swing\n")

    def test_usage(self):
        for arguments in [(), ("draw",), ("compute", "case.toml")]:
            ended = self.run_program(PENDULUM, *arguments)
            self.assertEqual(ended.returncode, 2)
            self.assertIn("usage: literate_pendulum compute CASE FOLDER", ended.stderr)
        self.assertEqual(self.run_program(PENDULUM, "--help").returncode, 0)
        self.assertEqual(self.run_program(RESULTS, "--help").returncode, 0)
        self.assertEqual(self.run_program(RESULTS).returncode, 2)


class Registered(Folder):
    def changed(self, change):
        registered = copy.deepcopy(REGISTERED)
        change(registered)
        return registered

    def test_a_script_that_registers_the_same_gives_the_same_folder(self):
        SCHEMA.validate(REGISTERED)
        self.assertEqual(self.results_of(REGISTERED).returncode, 0)
        self.assertEqual(self.files(), {name: text.replace("case.toml", "PLACE") for name, text in GOLDEN.items()})

    def test_every_kind_of_criterion_is_read(self):
        quantity = {"number": 1.0, "bound": 0.1, "format": "fixed(1)"}
        limit = {"number": 2, "kind": "method", "reason": "x", "counting": 2}
        one = {"name": "x", "test": "at_most", "quantity": quantity, "limit": limit}
        criteria = [one, {**one, "test": "agrees", "stated": quantity},
                    {"name": "x", "test": "in_each", "cases": "points", "each": [one, one]}]
        registered = {"schema": 1, "claims": {"c": {"route": "r", "expected": "holds", "criteria": criteria, "place": "fit.py:3"}}}
        SCHEMA.validate(registered)
        self.assertEqual(self.results_of(registered).returncode, 0)
        results = json.loads((self.output / "results.json").read_text())
        self.assertEqual(results["claims"]["c"]["place"], "fit.py:3")

    def test_a_failed_check_exits_with_1_and_names_its_place(self):
        ended = self.results_of({"schema": 1, "checks": {"c": {"statement": "s", "passed": False, "place": "fit.py:9"}}})
        self.assertEqual((ended.returncode, ended.stderr), (1, "fit.py:9: check 'c' failed: s\n"))

    def test_each_mistake_is_one_line_with_file_and_key(self):
        valid = SCHEMA.is_valid
        value = {"number": 1.5, "bound": 0.1, "format": "fixed(1)"}

        def values(**changes):
            return lambda r: r["values"].update(x={**value, **changes})

        # Some mistakes, such as an unknown unit, satisfy the schema.
        mistakes = [
            (lambda r: r.update(schema=2), False, ["registered.json: schema 2, and this program reads schema 1"]),
            (lambda r: r.pop("schema"), False, ["key 'schema' not found"]),
            (lambda r: r.update(valeus={}), False, ["unknown key 'valeus', did you mean 'values'?"]),
            (values(bund=0.1), False, ["values.x: unknown key 'bund', did you mean 'bound'?"]),
            (values(bound=-0.1), False, ["value 'x': the bound -0.1 is not finite or below zero"]),
            (values(bound="0.1"), False, ["(/values/x/bound) type must be number, but is string"]),
            (values(unit="{ }"), True, ["registered.json: value 'x': '{ }' is not a unit that UDUNITS-2 knows"]),
            (values(format="fixed"), False, ["values.x: 'fixed' is not a format: significant(4)"]),
            (values(format="exact()"), True, ["value 'x': 1.5 has an error and cannot be printed as exact()"]),
            (lambda r: r["values"]["period"].pop("bound"), True, ["value 'period': 2.36824634628601 has no error"]),
            (lambda r: r["tables"]["periods"]["rows"][1].pop(), True, ["table 'periods', row 2: 4 cells for 5 columns"]),
            (lambda r: r["tables"]["periods"]["rows"][1].__setitem__(1, 1.5), True, ["row 2, column 2 'integral': 1.5 has no error"]),
            (lambda r: r["figures"]["period"]["data"]["periods"]["columns"]["angle"].pop(), True, ["figure 'period': data 'periods' has 3"]),
            (lambda r: r["claims"]["longer"].update(expected="confirmed"), False, ["claims.longer: 'confirmed' is not a verdict"]),
            (lambda r: r["claims"]["longer"]["criteria"][0].update(test="less"), False, ["claims.longer: 'less' is not a test: at_most"]),
            (lambda r: r["claims"]["longer"]["criteria"][0]["limit"].update(kind="x"), False, ["claims.longer: 'x' is not a kind of limit"]),
            (lambda r: r.update(flags={"a b": {"value": True}}), False, ["flag 'a b': a name consists of"]),
            (lambda r: r.update(flags={"a": {"value": 1}}), False, ["(/flags/a/value) type must be boolean, but is number"]),
        ]
        for change, is_valid, parts in mistakes:
            with self.subTest(parts=parts):
                registered = self.changed(change)
                self.assertEqual(valid(registered), is_valid)
                self.refuses(self.results_of(registered), "registered.json", *parts)

    def test_invalid_json_is_one_line_with_its_place(self):
        self.refuses(self.results_of("half {"), "registered.json: parse error at line 1, column 1")
        self.refuses(self.results_of('{"schema": 1,\n"values": {"x": {"number": NaN}}}'), "line 2", '"number": N')
        self.refuses(self.results_of('{"schema": 1, "values": {"x": {"number": 1e999}}}'), "registered.json", "1e999")
        twice = '{"schema": 1, "values": {"x": {"text": "a"}, "x": {"text": "b"}}}'
        self.refuses(self.results_of(twice), "registered.json: the key 'x' is given twice")
        self.refuses(self.run_program(RESULTS, self.path / "none.json", self.output), "none.json")

    def test_a_text_that_is_not_utf8_is_refused(self):
        file = self.path / "registered.json"
        file.write_bytes(b'{"schema": 1, "values": {"x": {"text": "caf\xe9"}}}')
        self.refuses(self.run_program(RESULTS, file, self.output), "registered.json")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""import_test.py SOURCE: archives as Moodle, Canvas and GitHub Classroom give them become folders named for ids."""
import csv
import io
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

PROGRAM = Path(sys.argv.pop(1), "src/toolchain/course/import")
# Two people of one name, as in a large class.
WORKSHEET = """\
Identifier,"Full name","Email address",Status,Grade,"Maximum Grade","Grade can be changed","Last modified (submission)","Last modified (grade)"
"Participant 101","Alice Adams",alice@example.org,"Submitted for grading",,100.00,Yes,"Friday, 15 January 2027, 8:12 PM",-
"Participant 102","Alice Adams",adams2@example.org,"Submitted for grading",,100.00,Yes,"Saturday, 16 January 2027, 7:05 AM",-
"Participant 103","Bob O'Neill",bob@example.org,"No submission",,100.00,Yes,-,-
"""
GRADEBOOK = """\
Student,ID,SIS User ID,SIS Login ID,Section,Toy (4711)
    Points Possible,,,,,20
"Adams, Alice",7,,alice,S1,
"Adams, Alice",8,,adams2,S1,
"""
GRADES = """\
assignment_name,assignment_url,starter_code_url,github_username,roster_identifier,student_repository_name,student_repository_url,submission_timestamp,points_awarded,points_available
toy,u,u,aa,alice,toy-aa,u,2027-01-15 20:12:00 UTC,,
toy,u,u,bb,bob,toy-bb,u,,,
"""


def inner(name="src/square.cpp", text="int x;"):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr(name, text)
    return packed.getvalue()


class Import(unittest.TestCase):
    def setUp(self):
        self.held = tempfile.TemporaryDirectory(prefix="halfspace import ")
        self.addCleanup(self.held.cleanup)
        self.folder = Path(self.held.name)

    def zipped(self, entries):
        with zipfile.ZipFile(self.folder / "all.zip", "w") as archive:
            for name, content in entries:
                archive.writestr(name, content)

    def run_import(self, listed, **given):
        (self.folder / "list.csv").write_text(listed)
        environment = os.environ | {"LC_ALL": "C", "CALLER": str(self.folder), "FROM": "all.zip", "LIST": "list.csv",
                                    "INTO": "autumn", "ZONE": "Europe/Berlin"} | given
        self.ran = subprocess.run([PROGRAM], env=environment, capture_output=True, text=True, check=False)
        return self.ran.returncode

    def files(self):
        return sorted(str(path.relative_to(self.folder / "autumn")) for path in (self.folder / "autumn").rglob("*")
                      if path.is_file())

    def roster(self):
        with open(self.folder / "autumn.csv", newline="") as opened:
            return {row["student"]: (row["name"], row["submitted"]) for row in csv.DictReader(opened)}

    def test_two_people_of_one_name_keep_their_own_work_and_times(self):
        self.zipped([("Alice Adams_101_assignsubmission_file_/one.zip", inner(text="int one;")),
                     ("Alice Adams_102_assignsubmission_file_/two.zip", inner(text="int two;"))])
        self.assertEqual(self.run_import(WORKSHEET), 0, self.ran.stderr)
        self.assertEqual(self.files(), ["adams2@example.org.zip", "alice@example.org.zip"])
        with zipfile.ZipFile(self.folder / "autumn/adams2@example.org.zip") as archive:
            self.assertEqual(archive.read("src/square.cpp"), b"int two;")
        self.assertEqual(self.roster(), {
            "alice@example.org": ("Alice Adams", "2027-01-15T20:12:00+01:00"),
            "adams2@example.org": ("Alice Adams", "2027-01-16T07:05:00+01:00"),
            "bob@example.org": ("Bob O'Neill", "")})

    def test_a_file_is_of_whoever_moodle_names_first_whatever_it_is_called(self):
        evil = "x_101_assignsubmission_file_toy.zip"
        self.zipped([(f"Alice Adams_102_assignsubmission_file_/{evil}", inner(text="int two;")),
                     ("Alice Adams_101_assignsubmission_file_/toy.zip", inner(text="int one;"))])
        self.assertEqual(self.run_import(WORKSHEET), 0, self.ran.stderr)
        self.assertEqual(self.files(), ["adams2@example.org.zip", "alice@example.org.zip"])
        with zipfile.ZipFile(self.folder / "autumn/alice@example.org.zip") as archive:
            self.assertEqual(archive.read("src/square.cpp"), b"int one;")

    def test_a_participant_whose_name_imitates_an_entry_gets_their_own_work(self):
        self.zipped([("M 101 assignsubmission file  M_102_assignsubmission_file_/two.zip", inner(text="int two;"))])
        self.assertEqual(self.run_import(WORKSHEET), 0, self.ran.stderr)
        self.assertEqual(self.files(), ["adams2@example.org.zip"])

    def test_moodle_without_folders_and_a_folder_around_all_are_read_the_same(self):
        self.zipped([("all/Alice Adams_102_assignsubmission_file_x_101_assignsubmission_file_toy.zip", inner())])
        self.assertEqual(self.run_import(WORKSHEET), 0, self.ran.stderr)
        self.assertEqual(self.files(), ["adams2@example.org.zip"])

    def test_a_file_where_a_folder_is_wanted_costs_nobody_else_anything(self):
        self.zipped([("Alice Adams_101_assignsubmission_file_/src", "x"),
                     ("Alice Adams_101_assignsubmission_file_/src/square.cpp", "int x;"),
                     ("Alice Adams_102_assignsubmission_file_/src/square.cpp", "int x;")])
        self.assertEqual(self.run_import(WORKSHEET), 1)
        self.assertIn("_101_assignsubmission_file_/src/square.cpp' cannot be written", self.ran.stderr)
        self.assertEqual(self.files(), ["adams2@example.org/src/square.cpp", "alice@example.org/src"])

    def test_what_was_typed_into_moodle_is_told_as_such(self):
        self.zipped([("Alice Adams_101_assignsubmission_onlinetext/onlinetext.html", "x"),
                     ("Alice Adams_101_assignsubmission_file_/src/square.cpp", "int x;")])
        self.assertEqual(self.run_import(WORKSHEET), 1)
        self.assertIn("onlinetext.html' was typed into Moodle", self.ran.stderr)
        self.assertEqual(self.files(), ["alice@example.org/src/square.cpp"])

    def test_archives_are_those_that_are_graded(self):
        source = PROGRAM.parents[2] / "course/assignment/student.cpp"
        graded = re.search(r"endings = \{(.*?)\}", source.read_text(), re.DOTALL)[1]
        listed = re.search(r"^ARCHIVES = \((.*?)\)", PROGRAM.read_text(), re.MULTILINE)[1]
        self.assertEqual(re.findall(r'"(.*?)"', listed), re.findall(r'"(.*?)"', graded))
        self.zipped([("Alice Adams_101_assignsubmission_file_/toy.7z", "packed")])
        self.assertEqual(self.run_import(WORKSHEET), 0, self.ran.stderr)
        self.assertEqual(self.files(), ["alice@example.org.7z"])

    def test_a_damaged_archive_is_bad_input(self):
        self.zipped([("Alice Adams_101_assignsubmission_file_/src/square.cpp", "int x; " * 99)])
        whole = (self.folder / "all.zip").read_bytes()
        (self.folder / "all.zip").write_bytes(whole.replace(b"int x; ", b"int y; ", 1))
        self.assertEqual(self.run_import(WORKSHEET), 2)
        self.assertIn("is damaged or locked", self.ran.stderr)

    def test_several_uploads_of_one_student_stay_together(self):
        self.zipped([("Alice Adams_101_assignsubmission_file_/src/square.cpp", "int x;"),
                     ("Alice Adams_101_assignsubmission_file_/report.pdf", "pdf")])
        self.assertEqual(self.run_import(WORKSHEET), 0, self.ran.stderr)
        self.assertEqual(self.files(), ["alice@example.org/report.pdf", "alice@example.org/src/square.cpp"])

    def test_moodle_without_folders_and_without_names_is_understood(self):
        self.zipped([("Participant_101_assignsubmission_file_toy.tar.gz", "packed")])
        self.assertEqual(self.run_import(WORKSHEET), 0, self.ran.stderr)
        self.assertEqual(self.files(), ["alice@example.org.tar.gz"])

    def test_canvas_tells_two_of_one_name_by_their_number(self):
        self.zipped([("adamsalice_7_901_toy.zip", inner(text="int one;")),
                     ("adamsalice_LATE_8_902_toy.zip", inner(text="int two;"))])
        self.assertEqual(self.run_import(GRADEBOOK), 0, self.ran.stderr)
        self.assertEqual(self.files(), ["adams2.zip", "alice.zip"])
        with zipfile.ZipFile(self.folder / "autumn/adams2.zip") as archive:
            self.assertEqual(archive.read("src/square.cpp"), b"int two;")

    def test_clones_of_github_come_without_their_history_and_with_the_time_of_the_push(self):
        for login in ("aa", "bb", "stranger"):
            (self.folder / f"clones/toy-{login}/.git").mkdir(parents=True)
            (self.folder / f"clones/toy-{login}/.git/pack").write_text("large")
            (self.folder / f"clones/toy-{login}/square.cpp").write_text("int x;")
        self.assertEqual(self.run_import(GRADES, FROM="clones"), 1)
        self.assertIn("'toy-stranger' is of nobody in LIST", self.ran.stderr)
        self.assertEqual(self.files(), ["alice/square.cpp", "bob/square.cpp"])
        self.assertEqual(self.roster()["alice"], ("aa", "2027-01-15T20:12:00+00:00"))

    def test_what_leads_out_of_the_folder_is_told_and_left_out(self):
        self.zipped([("Alice Adams_101_assignsubmission_file_/../../evil.cpp", "x"),
                     ("Alice Adams_101_assignsubmission_file_/src/square.cpp", "int x;"), ("notes.txt", "x")])
        self.assertEqual(self.run_import(WORKSHEET), 1)
        self.assertEqual(self.files(), ["alice@example.org/src/square.cpp"])
        self.assertEqual(len(self.ran.stderr.splitlines()), 2)

    def test_nothing_is_written_over_and_nothing_half_written(self):
        self.zipped([("Alice Adams_101_assignsubmission_file_/a.zip", inner())])
        (self.folder / "autumn.csv").write_text("student\nmine\n")
        self.assertEqual(self.run_import(WORKSHEET), 2)
        self.assertIn("nothing is written over", self.ran.stderr)
        self.assertEqual((self.folder / "autumn.csv").read_text(), "student\nmine\n")
        (self.folder / "autumn.csv").unlink()
        self.assertEqual(self.run_import(WORKSHEET, ZONE="Nowhere/Land"), 2)
        self.assertIn("list.csv:2: ZONE: there is no time zone 'Nowhere/Land'", self.ran.stderr)
        self.assertFalse((self.folder / "autumn").exists())

    def test_bad_input_is_one_line_with_its_place(self):
        self.zipped([("x", "y")])
        for listed, given, said in (
                ("a,b\n1,2\n", {}, "has none of the columns Identifier, SIS Login ID, github_username"),
                (WORKSHEET, {"COLUMN": "Nickname"}, "has no column 'Nickname'"),
                (WORKSHEET, {"COLUMN": "Full name"}, "list.csv:2: Full name: 'Alice Adams' is no id"),
                (WORKSHEET.replace("adams2@", "alice@"), {}, "list.csv:3: Email address: 'alice@example.org' stands in line 2"),
                (WORKSHEET.replace("Friday", "Freitag"), {}, "list.csv:2: the time 'Freitag, 15 January 2027, 8:12 PM'"),
                (WORKSHEET, {}, "holds no submission of anybody in LIST, as Moodle names them"),
                (WORKSHEET, {"FROM": "none.zip"}, "FROM: cannot read"),
                (WORKSHEET, {"FROM": ""}, "FROM is missing")):
            with self.subTest(said):
                self.assertEqual(self.run_import(listed, **given), 2)
                self.assertIn(said, self.ran.stderr)
                self.assertEqual(len(self.ran.stderr.splitlines()), 1)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks are filled into the files that Moodle and Canvas export, and nothing else changes."""
import tempfile
import unittest
from pathlib import Path

import toy_course
from toy_course import TOY

import assignment
from class_file import ClassFile
from errors import BadInput

TOY_ASSIGNMENT = assignment.read(TOY / "assignment.toml")
ENGLISH = '''\ufeffIdentifier,"Full name","Email address",Status,Grade,"Maximum Grade","Grade can be changed","Last modified (submission)",\
"Last modified (grade)","Feedback comments"
"Participant 4711","Ada Love",ada@uni.edu,"Submitted for grading",,30.00,Yes,"Friday, 15 January 2027, 8:12 PM",-,"well, ""fine"""
"Participant 4712","Bob B",bob@uni.edu,"No submission",12.00,30.00,Yes,-,-,
'''
GERMAN = """ID,"Vollständiger Name",E-Mail-Adresse,Status,Bewertung,Bestwertung,"Bewertung kann geändert werden","Zuletzt geändert (Bewertung)"
"Teilnehmer/in4711","Ada Love",ada@uni.edu,Eingereicht,,"30,00",Ja,-
"Teilnehmer/in4712","Bob B",bob@uni.edu,Eingereicht,,"30,00",Ja,-
"""
FRENCH = """Identifiant,"Nom complet","Numéro d'identification",Statut,"Marqueur",Note,"Note maximale","La note peut être modifiée"
"Participant 4711","Ada Love",1001,Remis,-,-,"30,00",Oui
"Participant 4712","Bob B",1002,Remis,-,-,"30,00",Oui
"""
CANVAS = """Student,ID,SIS User ID,SIS Login ID,Section,Quiz (77),Toy (88),Final Score\r
,,,,,Manual Posting,,\r
    Points Possible,,,,,5,30,(read only)\r
"Love, Ada",4711,u1,ada@uni.edu,A,4,,80\r
"B, Bob",4712,u2,bob@uni.edu,A,,12,60\r
"Student, Test",4799,,abc,A,,,\r
"""


class ClassFiles(unittest.TestCase):
    def file(self, text):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        path = Path(scratch.name, "class.csv")
        path.write_text(text, encoding="utf-8", newline="")
        return ClassFile(path, TOY_ASSIGNMENT)

    def changed(self, text, marks):
        """Returns pairs of the lines that change, before and after."""
        after = self.file(text).filled(marks)
        pairs = zip(text.replace('"', "").splitlines(True), after.replace('"', "").splitlines(True), strict=True)
        return [(one, other) for one, other in pairs if one != other]

    def test_moodle_worksheets_in_any_language_are_filled(self):
        for text, before, after in ((ENGLISH, "grading,,30.00", "grading,28.50,30.00"), (GERMAN, "Eingereicht,,30,00", "Eingereicht,28,50,30,00"),
                                    (FRENCH, "Remis,-,-,30,00", "Remis,-,28,50,30,00")):
            ((one, other),) = self.changed(text, {"4711": 28.5})
            self.assertEqual(other, one.replace(before, after))

    def test_a_student_without_a_new_mark_keeps_the_old_one(self):
        self.assertIn("No submission,12.00", self.file(ENGLISH).filled({"4711": 30}))

    def test_the_byte_order_mark_and_quotation_marks_are_kept(self):
        filled = self.file(ENGLISH).filled({})
        self.assertTrue(filled.startswith("\ufeffIdentifier,"))
        self.assertIn('"well, ""fine"""', filled)

    def test_the_canvas_column_is_found_by_the_title_of_the_assignment(self):
        self.assertEqual(self.changed(CANVAS, {"4711": 28.5}), [("Love, Ada,4711,u1,ada@uni.edu,A,4,,80\r\n", "Love, Ada,4711,u1,ada@uni.edu,A,4,28.50,80\r\n")])

    def test_ids_that_are_not_system_numbers_are_found_in_any_cell(self):
        for text in (ENGLISH, GERMAN, CANVAS):
            ((_, other),) = self.changed(text, {"Ada@uni.edu": 1})
            self.assertIn("ada@uni.edu", other)

    def test_an_id_in_no_row_or_in_several_rows_is_bad_input(self):
        with self.assertRaisesRegex(BadInput, "class.csv: the id '4713' is in 0 rows instead of one"):
            self.file(ENGLISH).row_of("4713")
        with self.assertRaisesRegex(BadInput, "the id 'A' is in 3 rows"):
            self.file(CANVAS).row_of("A")

    def test_a_file_of_a_different_kind_is_bad_input(self):
        for text, error in (("student,points\nada,1\n", "neither a Moodle grading worksheet nor a Canvas gradebook"),
                            ("", "neither a Moodle grading worksheet"),
                            (ENGLISH.replace("30.00", "100.00"), "maximum mark is 100.00, but the assignment has 30 points"),
                            ("Identifier,Name\nParticipant 1,Ada\n", "no column of marks precedes a column with the maximum mark"),
                            (CANVAS.replace("Toy (88)", "Sphere (88)"), "0 columns instead of one begin with 'Toy \\('"),
                            (CANVAS.replace(",5,30,", ",5,31,"), "maximum mark is 31, but the assignment has 30 points")):
            with self.subTest(error), self.assertRaisesRegex(BadInput, error):
                self.file(text)


if __name__ == "__main__":
    toy_course.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The findings of `literate check`."""

import unittest

from paper import PaperTest

from literate_tools.typed_numbers import typed_in_script, typed_numbers

UNITS = ("mL", "L", "V", "rpm", "K", "kN", "min", "MPa", "°C", "percent", "metres", "GB", "µm", "lbf/in", "Hz")
BETWEEN = (" {}", "~{}", "\\,{}", "\\ {}", "-{}", "{}", "{{}} {}", "\\;{}", " \\text{{{}}}", "\\,\\mathrm{{{}}}", " \\unit{{{}}}", "~\\si{{{}}}",
           "\\,\\mbox{{{}}}", "\n{}")


class TypedNumbers(unittest.TestCase):
    def test_a_number_with_a_unit_is_typed_whatever_separates_them(self):
        for unit in UNITS:
            for between in BETWEEN:
                with self.subTest(unit=unit, between=between):
                    self.assertEqual(typed_numbers(f"It is 25{between.format(unit)} of it.\n"), [(1, "25")])

    def test_other_ways_to_write_a_quantity_are_found(self):
        for text in (r"\qty{60}{K}", r"\SI{60}{\kelvin}", r"$60$ K", r"$60\,\mathrm{K}$", r"$60~\text{K}$", r"60\,\unit{\degreeCelsius}", r"5\,\%",
                     r"$5\,\%$", r"90$^\circ$", r"$90^\circ$", r"3~in", "3 in.", r"3 $\Omega$", r"$3\,\Omega$", r"24\,$\mu$m", r"7\,µm",
                     r"60~\textcelsius", r"\[ x = 5\,\mathrm{mm} \]"):
            with self.subTest(text):
                self.assertEqual(len(typed_numbers(text)), 1)

    def test_a_number_of_more_than_two_digits_is_typed(self):
        for text, number in (("4.27 of it", "4.27"), ("123", "123"), ("1,234 cases", "1,234"), ("12\\,500", "12\\,500"), ("$p = 7.25$", "7.25"),
                             ("1.23e-5", "1.23e-5"), (r"$1.23 \times 10^{4}$", r"1.23 \times 10^{4}"), ("0.0123", "0.0123"),
                             ("in 1198 cases", "1198"), ("of 1998 N", "1998")):
            with self.subTest(text):
                self.assertEqual(typed_numbers(text), [(1, number)])

    def test_other_numbers_are_exempt(self):
        for text in ("order 2", "40 elements", "2000 cases", "$x^2$", "$2\\Omega$", "$1/3$", "page 12", "3 in the box", "(1987)", "28 November 2026", "in 1998", "Since~1998, it", "MEAE-4960",
                     r"\cite{a}, pp. 123--145", r"\cite[p.~123]{a}", r"section 3.14 of~\cite{x}", r"eq.~(4.45) of \cite{x}", r"\ref{fig:123}", r"\val{x123}",
                     r"\vspace{2.5mm}", r"\hskip 2.55pt", r"\rule{1.5cm}{1ex}", r"\includegraphics[width=10.5cm]{a123}", r"\\[2.55mm] text", r"\verb+123+",
                     r"\begin{tabular}{p{12.5cm}}a\end{tabular}", r"\begin{minipage}{0.455\linewidth}a\end{minipage}", r"\[ x = 0.125 y \]",
                     "\\begin{equation}\n0.123 x\n\\end{equation}", "% 12.34", "12.34 % constant: as the paper prints it", r"\quoted{12.34 m}",
                     "\\usepackage[left=24.5mm]{geometry}\n\\begin{document}"):
            with self.subTest(text):
                self.assertEqual(typed_numbers(text), [])

    def test_findings_have_the_lines_of_the_file(self):
        text = "\\newcommand\\x{12.34}\n\\begin{document}\n% 12.34\n\\begin{align}\n1.234\n\\end{align}\n\\cite[\n1.234]{x}\n5 mm\n\\end{document}"
        self.assertEqual(typed_numbers(text), [(9, "5")])

    def test_typed_numbers_are_found_in_strings_plots_and_data_of_scripts(self):
        script = "set title 'at 5 mm'\nset label \"4.27\" # 1.234\nset xrange [0:1.234]\nplot x using 1:($2*1.234) lc '#012345', \\\n  2.345\n$d << EOF\n"
        self.assertEqual(typed_in_script(script), [(1, "5"), (2, "4.27"), (4, "1.234"), (5, "2.345"), (6, "a block of data")])
        self.assertEqual(typed_in_script("plot 1.234 # constant: a guide to the eye\nplot x with lines lw 2\n"), [])


class Check(PaperTest):
    def check(self, *arguments: str) -> tuple[int, list[str]]:
        self.paper.make()
        code, output = self.paper.literate("check", str(self.paper.settings), *arguments)
        return code, output.splitlines()

    def test_a_correct_paper_has_no_findings(self):
        self.assertEqual(self.check(), (0, []))

    def test_findings_name_their_places(self):
        self.paper.replace("compute.py", "    document.flag", "    document.value('left', 5)\n    document.flag")
        self.paper.replace("paper/small.tex", r"\statement[us]{short}{It fits into a room of \val{share} of the house.}", "")
        self.paper.replace("paper/small.tex", "{big}{small}", r"{big}{\val{shaer} small}")
        self.paper.replace("paper/sections/more.tex", "More", "In 25~mL, more")
        self.paper.replace("figures/line.gp", "plot", "set title 'of 1.234'\nplot")
        self.assertEqual(self.check(), (1, [
            "paper/sections/more.tex:1: 25 is typed: register it, or end the line with '% constant: reason' if it is not a result",
            "figures/line.gp:1: 1.234 is typed: register it, or end the line with '# constant: reason' if it is not a result",
            "paper/small.tex:8: unknown value 'shaer', did you mean 'share'?",
            "compute.py:8: value 'left' is printed nowhere",
            "compute.py:13: claim 'short' has no \\statement"]))

    def test_names_in_branches_that_are_not_taken_count_as_used(self):
        self.paper.replace("compute.py", "    document.flag", "    document.value('left', 5)\n    document.flag")
        self.paper.replace("paper/small.tex", "{big}{small}", r"{big}{\input{sections/small}}")
        self.paper.write("paper/sections/small.tex", r"\val{left}")
        self.paper.write("paper/other/paper.tex", r"\val{unknown} 1.234")
        self.assertEqual(self.check(), (0, []))

    def test_quotations_are_looked_up(self):
        self.paper.replace("paper/sections/more.tex", "More", "\\quoted{the first  effi\\-cient \\dots\\ of $5\\,\\%$ -- ``so''} and\n\\quoted{not there} are")
        self.paper.write("text.txt", "Of\nThe First eﬃ-\ncient way\nout of 5 % – “so” it ends.\n")
        self.assertEqual(self.check("--paper", "text.txt"), (1, ["paper/sections/more.tex:2: text.txt does not contain “not there”"]))


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What became of a fault."""

from dataclasses import dataclass


@dataclass
class Result:
    fault: str
    status: int | None
    said: str
    pdf_survived: bool
    same_again: bool
    verdict: str  # good; or stuck, false, hung, no cause, the PDF was lost, left running

    def row(self):
        cell = lambda text: str(text).replace("|", "¦").replace("\n", " ")[:150]
        status = "hung" if self.status is None else self.status
        yes = {True: "yes", False: "NO"}
        return f"| {cell(self.fault)} | {status} | {cell(self.said)} | {yes[self.pdf_survived]} | {yes[self.same_again]} | {self.verdict} |"


HEAD = "| fault | exit | line said | PDF survived | next make: same bytes | verdict |\n|---|---|---|---|---|---|"

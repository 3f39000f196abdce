# overprints.py PDF: says where a word of a PDF stands on another one, and ends with 1 if one does.
import html
import re
import subprocess
import sys

WORD = re.compile(r'<word xMin="(\S+)" yMin="(\S+)" xMax="(\S+)" yMax="(\S+)">(.*?)</word>')


def overlap(a, b):
    """How wide and how high two boxes are over one another, in points."""
    return min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])


def stand_on_one_another(a, b):
    # The boxes are of the font's height, and so reach into the next line; formulas stack signs that are one letter wide.
    if len(a[4]) < 2 or len(b[4]) < 2:
        return False
    width, height = overlap(a, b)
    return width > 1 and height > 0.6 * min(a[3] - a[1], b[3] - b[1])


text = subprocess.run(["pdftotext", "-bbox", sys.argv[1], "-"], check=True, capture_output=True, text=True).stdout
n_found = 0
for number, page in enumerate(text.split("<page ")[1:], 1):
    words = sorted((*map(float, found[:4]), html.unescape(found[4])) for found in WORD.findall(page))
    for i, word in enumerate(words):
        for other in words[i + 1:]:
            if other[0] > word[2]:
                break
            if stand_on_one_another(word, other):
                n_found += 1
                print(f"page {number}: '{other[4]}' stands on '{word[4]}' at {other[0]:.0f}, {other[1]:.0f}")
sys.exit(n_found > 0)

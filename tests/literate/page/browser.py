# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens a page in Chromium and returns the findings of Chromium and axe-core."""

import json
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

BUILD = Path(__file__).resolve().parents[3] / "build"
AXE = [BUILD / folder / "node_modules/axe-core/axe.min.js" for folder in ("npm", "axe")]

# Runs inside the page, in a frame of the given width. The frame around it prints the posted message.
LOOK = """
addEventListener("load", async () => {
  if (%(opens_card)s) document.querySelector("button[popovertarget]").click();
  const violations = (await axe.run(document, {resultTypes: ["violations"]})).violations;
  parent.postMessage({
    violations: violations.map((found) => found.id + ": " + found.nodes.map((node) => node.html).join(" ").slice(0, 300)),
    requests: performance.getEntriesByType("resource").map((entry) => entry.name).filter((name) => !name.startsWith("data:")),
    width: document.scrollingElement.scrollWidth,
    cards: [...document.querySelectorAll("article[popover]")].filter((card) => card.offsetHeight).length,
    card: document.querySelector(":popover-open")?.textContent ?? "",
    background: getComputedStyle(document.documentElement).backgroundColor,
    dead: [...document.querySelectorAll('a[href^="#"]')].map((link) => decodeURIComponent(link.hash.slice(1)))
      .filter((name) => !document.getElementById(name)),
    blind: [...document.images].filter((image) => !image.alt || !image.naturalWidth).length,
  }, "*");
});
"""
FRAME = """<body style="margin:0"><iframe src="look.html" style="width:%dpx;height:900px;border:0"></iframe>
<script>addEventListener("message", (event) => { document.body.textContent = "found" + JSON.stringify(event.data) + "end"; })</script>"""


def missing_tool():
    """Returns a sentence about a missing tool, or None."""
    if not chromium():
        return "chromium is not installed"
    return None if any(file.is_file() for file in AXE) else "axe-core is not installed below build/npm"


def chromium():
    return shutil.which("chromium") or shutil.which("google-chrome")


def look(page, width, scheme="light", opens_card=False):
    """Returns measurements of the page at a width; see LOOK."""
    axe = next(file for file in AXE if file.is_file()).read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        scripts = f"<script>{axe}</script><script>{LOOK % {'opens_card': json.dumps(opens_card)}}</script>"
        text = page.read_text(encoding="utf-8").replace("</body>", f"{scripts}</body>")
        Path(folder, "look.html").write_text(text, encoding="utf-8")
        Path(folder, "frame.html").write_text(FRAME % width, encoding="utf-8")
        ran = subprocess.run([chromium(), "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", f"--user-data-dir={folder}/user", "--dump-dom",
                              f"--blink-settings=preferredColorScheme={0 if scheme == 'dark' else 1}", "--virtual-time-budget=100000",
                              f"file://{folder}/frame.html"], capture_output=True, text=True, check=True)
    found = re.search(r"found(\{.*\})end", ran.stdout, re.DOTALL)
    assert found, f"the page reported nothing:\n{ran.stdout[-1000:]}{ran.stderr[-1000:]}"
    return json.loads(found[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))

# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds of every page of the engine, in every way that it is read: wide and on a phone, light, dark and on paper, with
and without its script. Each check tells a claim, and what contradicts it."""
import json
import pathlib
import re
import shutil

from browser import Browser

SKIPPED = 77
AXE = pathlib.Path(__file__).resolve().parents[3] / "build/axe/node_modules/axe-core/axe.min.js"
WIDE, PHONE = (1280, 900), (390, 800)
WAYS = [(size, media, scheme, is_scripted)
        for size in (WIDE, PHONE)
        for media, scheme in (("screen", "light"), ("screen", "dark"), ("print", "light"))
        for is_scripted in (True, False)]


class Claims:
    def __init__(self):
        self.n_failed = self.n_tried = 0
        self.where = ""

    def __call__(self, text, wrong):
        """Tells a claim if anything contradicts it: a list of what is wrong, or whether something is."""
        self.n_tried += 1
        if wrong:
            self.n_failed += 1
            print(f"FAILED: {self.where}{text}: {wrong if not isinstance(wrong, list) else wrong[:5]}", flush=True)


def judged(claim, check):
    """Has a browser shown to `check`, which says whether there was axe-core, and returns the exit status."""
    program = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not program:
        print('skipped: there is no chromium; "make setup test-all" installs it')
        return SKIPPED
    browser = Browser(program)
    try:
        has_axe = check(browser)
    finally:
        browser.close()
    print(f"{claim.n_failed} of {claim.n_tried} claims failed")
    if claim.n_failed:
        return 1
    if not has_axe:
        print('skipped: there is no axe-core; "make setup test-all" brings it')
    return 0 if has_axe else SKIPPED


def check_all(claim, browser, page):
    """Every way of reading, every card, and axe-core in half of the ways; says whether that was there."""
    check_ways(claim, browser, page)
    has_axe = check_accessibility(claim, browser, page)
    check_keyboard(claim, browser, page)
    check_cards(claim, browser, page)
    tell_first_paint(browser, page)
    return has_axe


def loud(browser, page):
    """What the console said, and what was asked of the network."""
    said = [event["params"] for event in browser.events
            if event["method"] in ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded")]
    asked = [event["params"]["request"]["url"] for event in browser.events
             if event["method"] == "Network.requestWillBeSent"]
    return said, [url[:80] for url in asked if url != page and not url.startswith(("data:", "blob:"))]


def check_ways(claim, browser, page):
    """The page is whole in each of the twelve ways of reading it."""
    for (width, height), media, scheme, is_scripted in WAYS:
        way = f"{width} px, {media} {scheme}, {'with' if is_scripted else 'without'} script"
        claim.where = way + ": "
        browser.resize(width, height)
        browser.show(media, scheme)
        browser.runs_scripts = is_scripted
        browser.open(page)
        check_whole(claim, browser, page)
        if media == "screen":
            # Not innerWidth: on a phone it grows with what is too wide.
            claim("nothing is wider than the window", browser.evaluate(
                f"document.scrollingElement.scrollWidth > {width} ? [document.scrollingElement.scrollWidth] : []"))
            claim("every formula begins where it is seen or can be scrolled to", browser.evaluate(
                "[...document.querySelectorAll('.lit-equation > math')].map(e => [e.parentNode.id, e.getBoundingClientRect().left"
                " - e.parentNode.getBoundingClientRect().left + e.parentNode.scrollLeft]).filter(([, left]) => left < -1)"))
            claim("light and dark are what the reader's system says", browser.evaluate(
                "(() => { const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number);"
                f" const isDark = r + g + b < 384; return isDark !== {json.dumps(scheme == 'dark')}; }})()"))
        else:
            check_paper(claim, browser)
    claim.where = ""
    browser.runs_scripts = True
    browser.show()


def check_whole(claim, browser, page):
    claim("every drawing is seen", browser.evaluate(
        "[...document.querySelectorAll('main img')].filter(e => !e.getBoundingClientRect().width ||"
        " !e.getBoundingClientRect().height || e.naturalWidth === 0).map(e => e.alt || e.id)"))
    claim("every drawing has words for those who do not see it", browser.evaluate(
        "[...document.querySelectorAll('main img')].filter(e => e.alt.length < 20).map(e => e.id)"))
    claim("every link within the page has its target", browser.evaluate(
        "[...document.querySelectorAll('a[href^=\"#\"]')].map(e => decodeURIComponent(e.getAttribute('href')))"
        ".filter(h => !document.getElementById(h.slice(1)))"))
    claim("no two elements share an id", browser.evaluate(
        "[...document.querySelectorAll('[id]')].map(e => e.id).filter((id, i, all) => all.indexOf(id) !== i)"))
    claim("all text has room", browser.evaluate(
        "[...document.querySelectorAll('main p, main h1, main h2, main h3, main figcaption, main pre')]"
        ".filter(e => e.textContent.trim() && !e.closest('details, [hidden], .lit-card, .lit-said') &&"
        " !e.getBoundingClientRect().height).map(e => e.textContent.slice(0, 40))"))
    said, asked = loud(browser, page)
    claim("the console stays empty", said)
    claim("nothing is asked of the network", asked)


def check_paper(claim, browser):
    claim("paper has no tools", browser.evaluate(
        "[...document.querySelectorAll('#contents, .lit-tools, .lit-card, .lit-data, .lit-listing-bar')]"
        ".filter(e => e.getBoundingClientRect().height).map(e => e.className || e.id)"))
    claim("no listing is cut off on paper", browser.evaluate(
        "[...document.querySelectorAll('main pre')].filter(e => e.scrollHeight > e.clientHeight + 1 ||"
        " e.scrollWidth > e.clientWidth + 1).map(e => e.closest('figure')?.id || e.textContent.slice(0, 40))"))
    claim("paper is white", browser.evaluate(
        "getComputedStyle(document.body).backgroundColor !== 'rgb(255, 255, 255)'"))


# Each width with either scheme, and each of these with and without script once.
ON_SCREEN = [(size, "screen", scheme, (size == WIDE) == (scheme == "light"))
             for size in (WIDE, PHONE) for scheme in ("light", "dark")]


def check_accessibility(claim, browser, page):
    """axe-core finds nothing, wide and narrow, light and dark, with script and without. Says whether it was there."""
    if not AXE.is_file():
        return False
    axe = AXE.read_text(encoding="utf-8")
    for (width, height), media, scheme, is_scripted in ON_SCREEN:
        claim.where = f"{width} px, {scheme}, {'with' if is_scripted else 'without'} script: "
        browser.resize(width, height)
        browser.show(media, scheme)
        browser.runs_scripts = is_scripted
        browser.open(page)
        browser.evaluate(axe + "; 1")
        found = browser.evaluate(
            "axe.run(document, {resultTypes: ['violations']}).then(r => r.violations.map(v =>"
            " v.id + ' (' + v.nodes.length + '): ' + v.nodes.slice(0, 3).map(n => n.html.slice(0, 160)).join(' | ')))")
        claim("axe-core finds nothing", found)
    claim.where = ""
    browser.runs_scripts = True
    browser.show()
    return True


MARKS = "main :is(a.lit-claim, .lit-value, a.lit-ref, a.lit-cite, .lit-number-button)"


def check_keyboard(claim, browser, page):
    """The Tab key comes to every mark outside formulas, and each opens its card."""
    browser.resize(*WIDE)
    browser.open(page)
    n_marks = browser.evaluate(
        f"(() => {{ window.marks = [...document.querySelectorAll('{MARKS}')].filter(m => !m.closest('math') &&"
        " !m.parentElement.closest('.lit-value'));"
        " window.opened = new Set(); window.ended = false;"
        " document.addEventListener('focusin', (event) => {"
        "   const card = document.getElementById('lit-card');"
        "   if (card) opened.add(card.previousElementSibling);"
        "   if (event.target.matches('.lit-skip') && opened.size) ended = true; });"
        " return marks.length; })()")
    claim("there are marks to point at", [] if n_marks else ["none"])
    for _ in range(12 * n_marks + 2000):
        browser.press("Tab")
        if _ % 50 == 49 and browser.evaluate("ended || document.activeElement === document.body"):
            break
    claim("the Tab key opens every card", browser.evaluate(
        "marks.filter(m => !opened.has(m) && m.getClientRects().length).map(m => m.outerHTML.slice(0, 120))"))
    return n_marks


def check_cards(claim, browser, page):
    """Pointer, keys and touch open a card and close it."""
    browser.resize(*WIDE)
    browser.open(page)
    kinds = [kind for kind in ("a.lit-claim", ".lit-value", "a.lit-ref", "a.lit-cite", ".lit-number-button")
             if browser.evaluate(f"!!document.querySelector('main p {kind}, main .lit-equation {kind}')")]
    claim("there is a claim, a value and a reference", [k for k in ("a.lit-claim", ".lit-value", "a.lit-ref") if k not in kinds])
    for kind in kinds:
        mark = f"main :is(p, .lit-equation) {kind}"
        browser.point_at(mark)
        claim(f"the pointer opens the card of {kind}", not browser.wait_for("document.querySelector('.lit-card')"))
        claim(f"the card of {kind} is in the window", browser.evaluate(
            "(r => r.left < 0 || r.top < 0 || r.right > innerWidth || r.bottom > innerHeight || r.height < 20)"
            "(document.querySelector('.lit-card').getBoundingClientRect())"))
        claim(f"the card of {kind} shows no undefined thing", browser.evaluate(
            "/undefined|NaN|\\[object|null/.test(document.querySelector('.lit-card').textContent)"))
        browser.press("Escape")
        claim(f"Escape closes the card of {kind}, which stays closed", not browser.wait_for("!document.querySelector('.lit-card')")
              or browser.wait_for("document.querySelector('.lit-card')", 0.4))
    browser.resize(*PHONE)
    browser.open(page)
    at = browser.evaluate("location.hash")
    browser.touch("main p a.lit-claim")
    claim("a touch opens the card", not browser.wait_for("document.querySelector('.lit-card')"))
    claim("a touch that opens a card stays where it is", browser.evaluate("location.hash") != at)
    claim("the card lies at the lower edge of a phone", browser.evaluate(
        "Math.abs(document.querySelector('.lit-card').getBoundingClientRect().bottom - innerHeight) > 2"))
    browser.call("Emulation.setTouchEmulationEnabled", enabled=False)
    browser.resize(*WIDE)


def check_size(claim, page):
    """The file without its fonts and its data has at most 1.6 megabytes."""
    html = pathlib.Path(page).read_text(encoding="utf-8")
    fonts = sum(len(font) for font in re.findall(r"data:font/woff2;base64,[^\"]*", html))
    data = len(html.partition('id="lit-data">')[2].partition("</script>")[0])
    rest = len(html.encode()) - fonts - data
    print(f"{rest / 1e6:.2f} MB, besides {fonts / 1e6:.2f} MB of fonts and {data / 1e6:.2f} MB of data", flush=True)
    claim("a page has at most 1.6 MB besides fonts and data", [f"{rest / 1e6:.2f} MB"] if rest > 1.6e6 else [])


def tell_first_paint(browser, page):
    """Tells when something, and when the whole, is first painted; a busy machine takes its time, so that nothing is claimed."""
    browser.resize(*WIDE)
    times = []
    for _ in range(3):
        browser.open(page)
        browser.wait_for("performance.getEntriesByName('first-contentful-paint').length")
        times.append(browser.evaluate("[performance.getEntriesByName('first-contentful-paint')[0].startTime,"
                                      " performance.getEntriesByType('navigation')[0].loadEventEnd]"))
    painted, loaded = (min(several) for several in zip(*times))
    print(f"first paint after {painted:.0f} ms, everything loaded after {loaded:.0f} ms", flush=True)

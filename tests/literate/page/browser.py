# SPDX-License-Identifier: GPL-3.0-or-later
"""A headless Chromium that is told what to do through a pair of pipes; no network, nothing but Python."""
import json
import os
import subprocess
import tempfile


class Browser:
    """One page in one browser. `events` holds what the browser reported, in order."""

    def __init__(self, program):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.events = []
        self.runs_scripts = True  # whether the next page's own scripts run; evaluate() works either way
        self.last_id = 0
        self.buffer = b""
        from_us, self.to_browser = os.pipe()
        self.from_browser, to_us = os.pipe()
        # The browser reads on descriptor 3 and writes on 4.
        command = (
            f'exec 3<&{from_us} 4>&{to_us}; exec "$0" --headless=new --no-sandbox --disable-gpu --no-first-run'
            ' --disable-dev-shm-usage --hide-scrollbars --remote-debugging-pipe "--user-data-dir=$1"'
            ' "--host-resolver-rules=MAP * ~NOTFOUND" about:blank'
        )
        self.process = subprocess.Popen(
            ["bash", "-c", command, program, self.folder.name],
            pass_fds=(from_us, to_us), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(from_us)
        os.close(to_us)
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = None
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def call(self, method, **params):
        """Sends one command and returns its result; events that come meanwhile are kept."""
        self.last_id += 1
        message = {"id": self.last_id, "method": method, "params": params}
        if getattr(self, "session", None):
            message["sessionId"] = self.session
        os.write(self.to_browser, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.last_id:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def receive(self):
        while b"\0" not in self.buffer:
            part = os.read(self.from_browser, 1 << 20)
            if not part:
                raise RuntimeError("the browser ended")
            self.buffer += part
        text, self.buffer = self.buffer.split(b"\0", 1)
        message = json.loads(text)
        if "method" in message:
            self.events.append(message)
        return message

    def open(self, url):
        """Loads the page and waits for everything in it."""
        self.events.clear()
        self.call("Emulation.setScriptExecutionDisabled", value=not self.runs_scripts)
        self.call("Page.navigate", url=url)
        while not any(event["method"] == "Page.loadEventFired" for event in self.events):
            self.receive()
        # What is asked of the page later needs scripts; those that were not run are not run now.
        self.call("Emulation.setScriptExecutionDisabled", value=False)
        self.evaluate("document.fonts.ready.then(() => 1)")

    def resize(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=width < 600)

    def show(self, media="screen", scheme="light", reduces_motion=True):
        """Chooses paper or screen, light or dark, and whether things may move."""
        self.call("Emulation.setEmulatedMedia", media=media, features=[
            {"name": "prefers-color-scheme", "value": scheme},
            {"name": "prefers-reduced-motion", "value": "reduce" if reduces_motion else "no-preference"}])

    def press(self, key, code=None, text=None):
        """Presses and releases a key, as a reader does: "Tab", "Enter", "Escape", "a"."""
        codes = {"Tab": 9, "Enter": 13, "Escape": 27, "ArrowDown": 40, "ArrowUp": 38, " ": 32}
        text = text or {"Enter": "\r", " ": " "}.get(key) or (key if len(key) == 1 else None)
        more = {"text": text} if text else {}
        number = codes.get(key, ord(key.upper()) if len(key) == 1 else 0)
        self.call("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", key=key, code=code or key,
                  windowsVirtualKeyCode=number, **more)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, code=code or key, windowsVirtualKeyCode=number)

    def middle_of(self, selector):
        """Scrolls an element into the middle of the window and returns where it then is."""
        return self.evaluate(
            f"(() => {{ const e = document.querySelector({json.dumps(selector)});"
            " e.scrollIntoView({block: 'center', behavior: 'instant'}); const r = e.getClientRects()[0];"
            " return [r.x + r.width / 2, r.y + r.height / 2]; })()")

    def point_at(self, selector):
        x, y = self.middle_of(selector)
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def click(self, selector):
        x, y = self.middle_of(selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def touch(self, selector):
        x, y = self.middle_of(selector)
        self.call("Emulation.setTouchEmulationEnabled", enabled=True)
        self.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def wait_for(self, condition, seconds=5):
        """Waits until an expression is true, and says whether it came to be."""
        return self.evaluate(
            "new Promise((done) => { const end = performance.now() + " + str(1000 * seconds) + "; const look = () => {"
            f" if ({condition}) done(true); else if (performance.now() > end) done(false); else setTimeout(look, 20); }};"
            " look(); })")

    def evaluate(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def close(self):
        self.process.kill()
        self.process.wait()
        self.folder.cleanup()

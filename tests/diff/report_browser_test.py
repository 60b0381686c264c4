"""Opens a report of `ropesim diff` in headless Chromium and uses it as a person would.

usage: report_browser_test.py ROPESIM    (exit status 77: no chromedriver here)
"""

import base64
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request


class Browser:
    """Chromium through chromedriver, by the WebDriver protocol (W3C, 2018)."""

    def __init__(self):
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        for line in self.driver.stdout:
            if "on port" in line and "successfully" in line:
                port = line.strip().rstrip(".").split()[-1]
                self.address = f"http://127.0.0.1:{port}"
                break
        options = {"args": ["--headless=new", "--no-sandbox", "--window-size=1360,900"]}
        wanted = {"browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
        session = self.send("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})
        self.address += f"/session/{session['sessionId']}"

    def send(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.address + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise AssertionError(error.read().decode()) from error

    def script(self, text):
        return self.send("POST", "/execute/sync", {"script": text, "args": []})

    def press(self, key):
        keys = [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]
        self.send("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": keys}]})

    def click(self, selector):
        element = self.send("POST", "/element", {"using": "css selector", "value": selector})
        self.send("POST", f"/element/{next(iter(element.values()))}/click", {})

    def wait_for(self, expression, value):
        for _ in range(200):
            found = self.script(f"return {expression}")
            if found == value:
                return
            time.sleep(0.05)
        raise AssertionError(f"{expression} is {found!r}, expected {value!r}")

    def errors(self):
        return [entry["message"] for entry in self.send("POST", "/se/log", {"type": "browser"})]

    def screenshot(self, path):
        path.write_bytes(base64.b64decode(self.send("GET", "/screenshot")))

    def close(self):
        self.send("DELETE", "")
        self.driver.terminate()
        self.driver.wait()


def make_report(ropesim, folder):
    """Five frames: one of another motion, one missing, one cut off; and one that differs in nothing."""
    def run(*arguments):
        subprocess.run([ropesim, *arguments], cwd=folder, check=True)

    run("render", "seed", "--frames", "20:24", "--size", "480x320", "-o", "expected", "--quiet")
    run("render", "seed", "--frames", "20:24", "--size", "480x320", "-s", "63", "-o", "other", "--quiet")
    actual = shutil.copytree(folder / "expected", folder / "actual")
    shutil.copy(folder / "other/frame_0021.png", actual)
    (actual / "frame_0022.png").unlink()
    (actual / "frame_0023.png").write_bytes((folder / "expected/frame_0023.png").read_bytes()[:900])
    subprocess.run([ropesim, "diff", "expected", "actual", "--report", "report.html"], cwd=folder)
    return folder / "report.html"


def shown(which):
    """What the canvas in that figure of the stage holds: whether more than its corner is drawn."""
    return f"(() => {{ const c = document.querySelectorAll('#stage figure')[{which}].querySelector('canvas'); " \
           "const p = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; " \
           "return p.some((v, i) => i % 4 < 3 && v !== p[i % 4]); })()"


LEFT, RIGHT = "\ue012", "\ue014"


def use(browser, report):
    browser.send("POST", "/url", {"url": report.as_uri()})
    browser.wait_for("document.body.dataset.frame", "frame_0021.png")
    assert browser.script("return document.querySelectorAll('nav button').length") == 5
    assert "3 of 5 frames differ: 21 to 23" in browser.script("return document.getElementById('headline').textContent")
    assert "steps_per_frame 64 -> 63" in browser.script("return document.getElementById('why').textContent")
    for which in range(6):
        assert browser.script(f"return {shown(which)}"), f"figure {which} is empty"
    browser.screenshot(report.with_suffix(".png"))

    browser.press(RIGHT)
    browser.wait_for("document.body.dataset.frame", "frame_0022.png")
    assert "no such frame" in browser.script("return document.getElementById('stage').textContent")
    browser.press(RIGHT)
    browser.wait_for("document.body.dataset.frame", "frame_0023.png")
    browser.press(LEFT)
    browser.press(LEFT)
    browser.wait_for("document.body.dataset.frame", "frame_0021.png")

    browser.click("[data-mode=slider]")
    browser.wait_for("document.body.dataset.mode", "slider")
    before = browser.script("return document.querySelector('#stage figure:last-child canvas').toDataURL()")
    browser.script("const s = document.getElementById('split'); s.value = 900; s.dispatchEvent(new Event('input'))")
    time.sleep(0.3)
    assert browser.script("return document.querySelector('#stage figure:last-child canvas').toDataURL()") != before

    browser.press(" ")
    browser.wait_for("document.body.dataset.mode", "blink")
    browser.wait_for("document.body.dataset.shown", "actual")
    browser.press(" ")
    browser.wait_for("document.body.dataset.shown", "expected")
    assert browser.errors() == [], browser.errors()


def main():
    if not shutil.which("chromedriver"):
        print("chromedriver is not installed: not tested")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        report = make_report(sys.argv[1], pathlib.Path(folder))
        browser = Browser()
        try:
            use(browser, report)
        finally:
            browser.close()
    print("the report opens, its keys and slider work, its console is empty")
    return 0


if __name__ == "__main__":
    sys.exit(main())

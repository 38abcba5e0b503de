"""A headless Chromium, driven over its DevTools pipe; Python's standard library only.

Messages are JSON, each ended by a NUL, over file descriptors 3 (to the browser) and 4 (from it).
Source: chromedevtools.github.io/devtools-protocol; --remote-debugging-pipe.
"""

import base64
import fcntl
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

TIMEOUT = 60.0  # seconds that any answer may take


class BrowserError(Exception):
    """The browser did not do what it was asked for."""


def find():
    """The path of a Chromium, or None."""
    for name in ("chromium", "chromium-browser", "google-chrome"):
        path = shutil.which(name)
        if path:
            return path
    return None


class Browser:
    """A browser process with a profile of its own; use it in a with statement. `webgl`: drawn by the
    processor, or not at all."""

    def __init__(self, path, webgl=True):
        self._profile = tempfile.mkdtemp(prefix="boxbeam-browser-")
        to_read, self._write = os.pipe()
        self._read, to_write = os.pipe()
        high = [fcntl.fcntl(fd, fcntl.F_DUPFD, 20) for fd in (to_read, to_write)]
        os.close(to_read)
        os.close(to_write)

        def place_pipes():
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)

        self._process = subprocess.Popen(
            [path, "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run",
             "--disable-extensions", "--disable-background-networking", "--disable-component-update",
             "--disable-dev-shm-usage", "--hide-scrollbars", "--remote-debugging-pipe",
             *(["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if webgl else ["--disable-3d-apis"]),
             f"--user-data-dir={self._profile}", "about:blank"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            preexec_fn=place_pipes, pass_fds=(3, 4))
        for fd in high:
            os.close(fd)
        self._number = 0
        self._received = b""
        self._events = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.send("Browser.close")
            self._process.wait(10)
        except (BrowserError, OSError, subprocess.TimeoutExpired):
            self._process.kill()
            self._process.wait()
        os.close(self._write)
        os.close(self._read)
        shutil.rmtree(self._profile, ignore_errors=True)

    def _message(self, until):
        while b"\0" not in self._received:
            left = until - time.monotonic()
            if left <= 0 or not select.select([self._read], [], [], left)[0]:
                raise BrowserError("no answer in time")
            part = os.read(self._read, 1 << 16)
            if not part:
                raise BrowserError("the browser has ended")
            self._received += part
        message, self._received = self._received.split(b"\0", 1)
        return json.loads(message)

    def send(self, method, session=None, **parameters):
        """The result of a command; what the browser reports meanwhile is kept."""
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self._write, data):]
        until = time.monotonic() + TIMEOUT
        while True:
            answer = self._message(until)
            if answer.get("id") == self._number:
                if "error" in answer:
                    raise BrowserError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            if "method" in answer:
                self._events.append(answer)

    def wait_for(self, method, session):
        """The next event of that name that has not been taken, in the order of arrival."""
        until = time.monotonic() + TIMEOUT
        while True:
            for event in self._events:
                if event["method"] == method and event.get("sessionId") == session:
                    self._events.remove(event)
                    return event["params"]
            answer = self._message(until)
            if "method" in answer:
                self._events.append(answer)

    def events(self, session, *methods):
        """What has been reported so far, by name."""
        return [event for event in self._events
                if event.get("sessionId") == session and event["method"] in methods]

    def open(self, url, **emulation):
        """A page that has loaded the address."""
        return Page(self, url, **emulation)


class Page:
    """A page; `width` and `height` in CSS pixels, `scripts` whether its scripts run, `calm`
    whether its reader wants less motion."""

    def __init__(self, browser, url, width=1280, height=900, scripts=True, dark=False, calm=False):
        self._browser = browser
        target = browser.send("Target.createTarget", url="about:blank")["targetId"]
        self._target = target
        self._session = browser.send("Target.attachToTarget", targetId=target,
                                     flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.send(domain + ".enable")
        self.resize(width, height)
        features = [("prefers-color-scheme", "dark")] * dark + [("prefers-reduced-motion", "reduce")] * calm
        if features:
            self.send("Emulation.setEmulatedMedia",
                      features=[{"name": name, "value": value} for name, value in features])
        if not scripts:
            self.send("Emulation.setScriptExecutionDisabled", value=True)
        self.send("Page.navigate", url=url)
        browser.wait_for("Page.loadEventFired", self._session)

    def send(self, method, **parameters):
        return self._browser.send(method, self._session, **parameters)

    def close(self):
        self._browser.send("Target.closeTarget", targetId=self._target)

    def resize(self, width, height):
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=False)

    def run(self, expression):
        """The value of a JavaScript expression in the page, also where its own scripts are off."""
        answer = self.send("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise BrowserError(details.get("exception", {}).get("description", details["text"]))
        return answer["result"].get("value")

    def key(self, name):
        """Presses a key, "ArrowRight", "Enter"."""
        text = {"Enter": "\r", " ": " "}.get(name, "")
        code = {"ArrowLeft": 37, "ArrowRight": 39, "Enter": 13, " ": 32}[name]
        self.send("Input.dispatchKeyEvent", type="keyDown", key=name, text=text,
                  windowsVirtualKeyCode=code)
        self.send("Input.dispatchKeyEvent", type="keyUp", key=name, windowsVirtualKeyCode=code)

    def complaints(self):
        """Exceptions, and console messages that are errors or warnings."""
        texts = []
        for event in self._browser.events(self._session, "Runtime.exceptionThrown",
                                          "Runtime.consoleAPICalled", "Log.entryAdded"):
            of = event["params"]
            if event["method"] == "Runtime.exceptionThrown":
                texts.append(json.dumps(of["exceptionDetails"]))
            elif event["method"] == "Runtime.consoleAPICalled":
                if of["type"] in ("error", "warning", "assert"):
                    texts.append(json.dumps(of["args"]))
            elif of["entry"]["level"] in ("error", "warning"):
                # Reading pixels for a picture is slow where the processor draws.
                if "GPU stall due to ReadPixels" not in of["entry"]["text"]:
                    texts.append(of["entry"]["text"])
        return texts

    def requests(self):
        """The addresses that the page asked for, other than data inside it."""
        urls = [event["params"]["request"]["url"]
                for event in self._browser.events(self._session, "Network.requestWillBeSent")]
        return [url for url in urls if not url.startswith("data:")]

    def pdf(self):
        """The page as it prints."""
        answer = self.send("Page.printToPDF", printBackground=False, preferCSSPageSize=True)
        return base64.b64decode(answer["data"])

    def picture(self, path, clip=None):
        """Writes what is seen, or a part (x, y, width, height) of the page, as PNG."""
        more = {}
        if clip:
            more = {"clip": {"x": clip[0], "y": clip[1], "width": clip[2], "height": clip[3],
                             "scale": 1}}
        answer = self.send("Page.captureScreenshot", captureBeyondViewport=True, **more)
        with open(path, "wb") as file:
            file.write(base64.b64decode(answer["data"]))

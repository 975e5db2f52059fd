"""A headless Chromium that is driven through a pipe, as its DevTools protocol says: no port is opened."""

import base64
import json
import os
import subprocess
import time


class Browser:
    """One window. `events` are all that the browser has told of."""

    def __init__(self, *, width=1100, height=1000):
        to_browser, self._out = os.pipe()
        self._in, from_browser = os.pipe()
        self._messages, self._number, self.events, self._rest = [], 0, [], b""
        self._process = subprocess.Popen(
            ["chromium", "--headless=new", "--no-sandbox", "--no-first-run", "--hide-scrollbars", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--disable-background-networking", "--disable-dev-shm-usage",
             f"--window-size={width},{height}", "--remote-debugging-pipe", "about:blank"],
            preexec_fn=lambda: self._give(to_browser, from_browser), close_fds=False, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        targets = self._ask("Target.getTargets")["targetInfos"]
        page = next(target["targetId"] for target in targets if target["type"] == "page")
        self._session = self._ask("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    @staticmethod
    def _give(to_browser, from_browser):
        """It reads from 3 and writes to 4."""
        read, write = os.dup(to_browser), os.dup(from_browser)
        os.dup2(read, 3)
        os.dup2(write, 4)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.terminate()
        self._process.wait(timeout=20)
        os.close(self._out)
        os.close(self._in)

    def _read(self):
        while b"\0" not in self._rest:
            part = os.read(self._in, 1 << 20)
            if not part:
                raise RuntimeError("chromium has gone")
            self._rest += part
        message, self._rest = self._rest.split(b"\0", 1)
        return json.loads(message)

    def _ask(self, method, session=None, **parameters):
        self._number += 1
        request = {"id": self._number, "method": method, "params": parameters}
        if session:
            request["sessionId"] = session
        os.write(self._out, json.dumps(request).encode() + b"\0")
        while True:
            message = self._read()
            if message.get("id") == self._number:
                assert "error" not in message, (method, message["error"])
                return message["result"]
            self.events.append(message)

    def ask(self, method, **parameters):
        return self._ask(method, self._session, **parameters)

    def evaluate(self, expression):
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in answer, answer
        return answer["result"].get("value")

    def open(self, address):
        self.ask("Page.navigate", url=address)
        self.wait_for("document.readyState === 'complete'")

    def wait_for(self, condition, seconds=200):
        end = time.monotonic() + seconds
        while not self.evaluate(condition):
            assert time.monotonic() < end, f"in {seconds} s not: {condition}"
            time.sleep(0.05)

    def drag(self, start, end, steps=8):
        """With the left button, from a place of the window to another [pixels]."""
        self._mouse("mousePressed", *start)
        for i in range(1, steps + 1):
            self._mouse("mouseMoved", *(a + (b - a) * i / steps for a, b in zip(start, end)))
        self._mouse("mouseReleased", *end)

    def click(self, place):
        self.drag(place, place, 0)

    def _mouse(self, kind, x, y):
        self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=0 if kind == "mouseReleased" else 1,
                 clickCount=1)

    def screenshot(self, file):
        file.write_bytes(base64.b64decode(self.ask("Page.captureScreenshot")["data"]))

    def pdf(self, file):
        data = self.ask("Page.printToPDF", printBackground=True, preferCSSPageSize=False, paperWidth=8.27, paperHeight=11.69)
        file.write_bytes(base64.b64decode(data["data"]))

    def complaints(self):
        """What was said to the console, and what was refused."""
        return [event for event in self.events if event.get("method") in ("Runtime.consoleAPICalled", "Runtime.exceptionThrown",
                                                                         "Log.entryAdded")]

    def requests(self):
        """Addresses that were asked for, but for data in the page itself."""
        urls = [event["params"]["request"]["url"] for event in self.events if event.get("method") == "Network.requestWillBeSent"]
        return [url for url in urls if not url.startswith(("data:", "blob:"))]

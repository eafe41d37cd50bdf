# SPDX-License-Identifier: MIT
"""A headless Chromium and a headless Firefox, with the same methods, for .ci/browser.

Neither needs a driver program: Chromium speaks DevTools' protocol over a pipe, Firefox WebDriver BiDi over a
websocket (PyPI's websocket-client)."""

import base64
import json
import os
import pathlib
import queue
import re
import subprocess
import threading
import time

import websocket

KEYS = {" ": ("Space", 32, " "), "Tab": ("Tab", 9, "\ue004"), "Home": ("Home", 36, "\ue011"),
        "End": ("End", 35, "\ue010"), "ArrowLeft": ("ArrowLeft", 37, "\ue012"), "ArrowUp": ("ArrowUp", 38, "\ue013"),
        "ArrowRight": ("ArrowRight", 39, "\ue014"), "ArrowDown": ("ArrowDown", 40, "\ue015"),
        "Enter": ("Enter", 13, "\ue007")}


class Browser:
    """What both can do. `troubles` is what the console, the log and the network heard of."""

    def __init__(self):
        self.troubles = []
        self.count = 0

    def open(self, address):
        """Another page, or the same one anew."""
        self.navigate("about:blank")
        self.navigate(address)
        self.frame()

    def frame(self):
        """Wait until what has changed is drawn."""
        self.run("new Promise(go => requestAnimationFrame(() => requestAnimationFrame(() => go(0))))")

    def heard_of(self, address):
        if not address.startswith(("file:", "data:", "about:", "blob:")):
            self.troubles.append(f"the page asks for {address}")


class Chromium(Browser):
    """Commands go to its file 3 and come back on its 4."""

    name = "Chromium"

    def __init__(self, profile, scheme="light", motion="no-preference", language="en"):
        super().__init__()
        command_out, self.commands = os.pipe()
        self.answers, answer_in = os.pipe()

        def pipes():
            # Above 4 first: either may be 3 or 4 already.
            high = [os.dup2(command_out, 200), os.dup2(answer_in, 201)]
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)

        self.process = subprocess.Popen(
            [os.environ.get("CHROMIUM", "chromium"), "--headless=new", "--remote-debugging-pipe", "--no-sandbox",
             "--disable-gpu", "--no-first-run", f"--accept-lang={language}", f"--user-data-dir={profile}"],
            preexec_fn=pipes, close_fds=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(command_out)
        os.close(answer_in)
        self.buffer = b""
        self.session = None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")
        self.media(scheme, motion)

    def media(self, scheme="light", motion="reduce", **others):
        self.call("Emulation.setEmulatedMedia", media=others.pop("media", ""), features=[
            {"name": "prefers-color-scheme", "value": scheme}, {"name": "prefers-reduced-motion", "value": motion},
            *({"name": name.replace("_", "-"), "value": value} for name, value in others.items())])

    def close(self):
        self.session = None
        self.call("Browser.close")
        self.process.wait(20)

    def message(self):
        while b"\0" not in self.buffer:
            part = os.read(self.answers, 65536)
            if not part:
                raise SystemExit("Chromium ended")
            self.buffer += part
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while (answer := self.message()).get("id") != self.count:
            self.hear(answer)
        if "error" in answer:
            raise SystemExit(f"{method}: {answer['error']}")
        return answer["result"]

    def hear(self, event):
        method, about = event["method"], event.get("params", {})
        if method in ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded"):
            self.troubles.append(f"{method}: {about}")
        elif method == "Network.requestWillBeSent":
            self.heard_of(about["request"]["url"])
        elif method == "Page.loadEventFired":
            self.loaded = True

    def navigate(self, address):
        self.loaded = False
        self.call("Page.navigate", url=address)
        while not self.loaded:
            self.hear(self.message())

    def run(self, script):
        """The value of an expression in the page, awaited."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise SystemExit(f"{script}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def resize(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=2 if width < 900 else 1, mobile=min(width, height) < 500)

    def press(self, key):
        code, number, _ = KEYS[key]
        shared = {"key": key, "code": code, "windowsVirtualKeyCode": number}
        self.call("Input.dispatchKeyEvent", type="keyDown", **shared, **({"text": " "} if key == " " else {}))
        self.call("Input.dispatchKeyEvent", type="keyUp", **shared)

    def drag(self, points, pause, rest):
        """Press at the first point, move through the others, wait, let go."""
        for number, (x, y) in enumerate(points):
            if number == 0:
                self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
            self.call("Input.dispatchMouseEvent", type="mousePressed" if number == 0 else "mouseMoved", x=x, y=y,
                      button="left", buttons=1, clickCount=1)
            time.sleep(pause)
        time.sleep(rest)
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=x, y=y, button="left", clickCount=1)

    def touch(self, points):
        """The same with a finger."""
        for number, (x, y) in enumerate(points):
            self.call("Input.dispatchTouchEvent", type="touchMove" if number else "touchStart",
                      touchPoints=[{"x": x, "y": y}])
            time.sleep(0.02)
        time.sleep(0.2)
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def picture(self, file):
        file.write_bytes(base64.b64decode(self.call("Page.captureScreenshot", captureBeyondViewport=True)["data"]))


class Firefox(Browser):
    """Preferences stand in its profile."""

    name = "Firefox"

    def __init__(self, profile, scheme="light", motion="no-preference", language="en"):
        super().__init__()
        preferences = {"layout.css.prefers-color-scheme.content-override": 0 if scheme == "dark" else 1,
                       "ui.prefersReducedMotion": int(motion == "reduce"), "intl.accept_languages": language,
                       "app.update.enabled": False, "datareporting.policy.dataSubmissionEnabled": False,
                       "browser.shell.checkDefaultBrowser": False, "remote.active-protocols": 1}
        (pathlib.Path(profile) / "user.js").write_text("".join(
            f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in preferences.items()))
        self.process = subprocess.Popen(
            [os.environ.get("FIREFOX", "firefox-esr"), "--headless", "--no-remote", "--profile", str(profile),
             "--remote-debugging-port", "0"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE, text=True)
        lines = queue.Queue()
        threading.Thread(target=lambda: [lines.put(line) for line in self.process.stderr], daemon=True).start()
        address = None
        while not address:
            address = re.search(r"ws://\S+", lines.get(timeout=60))
        self.socket = websocket.create_connection(address.group() + "/session", timeout=60, suppress_origin=True)
        self.call("session.new", capabilities={})
        self.call("session.subscribe", events=["log.entryAdded", "network.beforeRequestSent"])
        self.context = self.call("browsingContext.getTree")["contexts"][0]["context"]

    def close(self):
        self.call("browser.close")
        self.process.wait(20)

    def call(self, method, **parameters):
        self.count += 1
        self.socket.send(json.dumps({"id": self.count, "method": method, "params": parameters}))
        while (answer := json.loads(self.socket.recv())).get("id") != self.count:
            about = answer.get("params", {})
            if answer.get("method") == "log.entryAdded":
                self.troubles.append(f"log: {about}")
            elif answer.get("method") == "network.beforeRequestSent" and about.get("context") == self.context:
                self.heard_of(about["request"]["url"])
        if answer["type"] == "error":
            raise SystemExit(f"{method}: {answer['error']}: {answer['message']}")
        return answer["result"]

    def navigate(self, address):
        self.call("browsingContext.navigate", context=self.context, url=address, wait="complete")

    def run(self, script):
        # As JSON: BiDi has a notation of its own for values
        answer = self.call("script.evaluate", target={"context": self.context}, awaitPromise=True,
                           expression=f"(async () => JSON.stringify(await ({script})))()")
        if answer["type"] == "exception":
            raise SystemExit(f"{script}: {answer['exceptionDetails']['text']}")
        value = answer["result"].get("value")
        return None if value is None else json.loads(value)

    def resize(self, width, height):
        self.call("browsingContext.setViewport", context=self.context, viewport={"width": width, "height": height})

    def press(self, key):
        value = KEYS[key][2]
        self.act({"type": "key", "id": "keys", "actions": [{"type": "keyDown", "value": value},
                                                           {"type": "keyUp", "value": value}]})

    def drag(self, points, pause, rest):
        moves = []
        for number, (x, y) in enumerate(points):
            moves.append({"type": "pointerMove", "x": round(x), "y": round(y), "duration": 0})
            if number == 0:
                moves.append({"type": "pointerDown", "button": 0})
            moves.append({"type": "pause", "duration": int(1000 * pause)})
        moves += [{"type": "pause", "duration": int(1000 * rest)}, {"type": "pointerUp", "button": 0}]
        self.act({"type": "pointer", "id": "mouse", "actions": moves})

    def act(self, source):
        self.call("input.performActions", context=self.context, actions=[source])

    def picture(self, file):
        answer = self.call("browsingContext.captureScreenshot", context=self.context, origin="document")
        file.write_bytes(base64.b64decode(answer["data"]))

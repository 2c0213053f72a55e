# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a window, driven over the protocol of its developer tools. Only the standard library is used."""
import base64
import json
import os
import pathlib
import signal
import socket
import struct
import subprocess
import time
import urllib.request

PATIENCE = 120.0  # seconds for a state to come about


class WebSocket:
    """A connection that sends and receives texts (RFC 6455)."""

    def __init__(self, address):
        host, path = address.removeprefix("ws://").split("/", 1)
        name, port = host.split(":")
        self.socket = socket.create_connection((name, int(port)), timeout=PATIENCE)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET /{path} HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                             f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n").encode())
        self.received = b""
        while b"\r\n\r\n" not in self.received:
            self.received += self.socket.recv(4096)
        self.received = self.received.split(b"\r\n\r\n", 1)[1]

    def send(self, text):
        data = text.encode()
        length = len(data)
        head = (struct.pack("!BB", 0x81, 0x80 | length) if length < 126
                else struct.pack("!BBH", 0x81, 0xFE, length) if length < 65536
                else struct.pack("!BBQ", 0x81, 0xFF, length))
        self.socket.sendall(head + bytes(4) + data)  # a mask of zeros changes nothing

    def take(self, count):
        while len(self.received) < count:
            more = self.socket.recv(65536)
            if not more:
                raise ConnectionError("the browser has ended")
            self.received += more
        out, self.received = self.received[:count], self.received[count:]
        return out

    def receive(self):
        text = b""
        while True:
            first, second = self.take(2)
            length = second & 0x7F
            if length == 126:
                length, = struct.unpack("!H", self.take(2))
            elif length == 127:
                length, = struct.unpack("!Q", self.take(8))
            data = self.take(length)
            if first & 0x0F in (0, 1):
                text += data
                if first & 0x80:
                    return text.decode()


class Page:
    """A page of the browser."""

    def __init__(self, address):
        self.connection = WebSocket(address)
        self.calls = 0
        self.complaints = []  # errors that the page wrote to the console or did not catch
        self.call("Runtime.enable")
        self.call("Page.enable")

    def call(self, method, **parameters):
        self.calls += 1
        self.connection.send(json.dumps({"id": self.calls, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.connection.receive())
            if message.get("id") == self.calls:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]
            self.note(message)

    def note(self, message):
        if message["method"] == "Runtime.exceptionThrown":
            details = message["params"]["exceptionDetails"]
            self.complaints.append(details.get("exception", {}).get("description", details["text"]))
        elif message["method"] == "Runtime.consoleAPICalled" and message["params"]["type"] == "error":
            self.complaints.append(" ".join(str(one.get("value", "")) for one in message["params"]["args"]))
        elif message["method"] == "Page.javascriptDialogOpening":
            # Only the question about unsaved work; its answer is not waited for here.
            self.calls += 1
            self.connection.send(json.dumps(
                {"id": self.calls, "method": "Page.handleJavaScriptDialog", "params": {"accept": True}}))

    def close(self):
        """Closes the page as its user does, and leaves it when it asks."""
        self.connection.send(json.dumps({"id": 0, "method": "Page.close", "params": {}}))
        try:
            while True:
                message = json.loads(self.connection.receive())
                if "method" in message:
                    self.note(message)
        except ConnectionError:
            pass

    def evaluate(self, expression):
        """The value of an expression of JavaScript; a promise is awaited."""
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']['exception']['description']}")
        return answer["result"].get("value")

    def wait_for(self, expression, what, meanwhile=lambda: None):
        """Waits until the expression holds, also while the page loads."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            try:
                if value := self.evaluate(expression):
                    return value
            except RuntimeError:
                pass
            meanwhile()
            time.sleep(0.1)
        raise AssertionError(f"{what}: not within {PATIENCE:.0f} s")

    def go_to(self, link):
        self.call("Page.navigate", url=link)

    def type(self, text):
        for letter in text:
            code = ord(letter.upper())
            self.call("Input.dispatchKeyEvent", type="keyDown", key=letter, text=letter, windowsVirtualKeyCode=code)
            self.call("Input.dispatchKeyEvent", type="keyUp", key=letter, windowsVirtualKeyCode=code)

    def press(self, key, control=False, shift=False):
        codes = {"Enter": 13, "Escape": 27, "PageDown": 34, "Delete": 46}
        code = codes.get(key, ord(key[0].upper()))
        held = {"modifiers": (2 if control else 0) + (8 if shift else 0)}
        described = {"key": key, "code": key if key in codes else "Key" + key.upper(), "windowsVirtualKeyCode": code}
        for name, number, is_held in (("Control", 17, control), ("Shift", 16, shift)):
            if is_held:
                self.call("Input.dispatchKeyEvent", type="rawKeyDown", key=name, code=name + "Left",
                          windowsVirtualKeyCode=number, **held)
        text = {"text": "\r"} if key == "Enter" else {}
        self.call("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", **described, **held, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", **described, **held)
        for name, number, is_held in (("Shift", 16, shift), ("Control", 17, control)):
            if is_held:
                self.call("Input.dispatchKeyEvent", type="keyUp", key=name, code=name + "Left",
                          windowsVirtualKeyCode=number)

    def mouse(self, kind, x, y, button="none"):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, clickCount=int(button != "none"))

    def touch(self, kind, *points):
        self.call("Input.dispatchTouchEvent", type=kind,
                  touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])

    def picture(self, file):
        pathlib.Path(file).write_bytes(base64.b64decode(self.call("Page.captureScreenshot")["data"]))


class Chromium:
    """The browser with a profile that outlives it."""

    def __init__(self, profile, link):
        port_file = pathlib.Path(profile) / "DevToolsActivePort"
        port_file.unlink(missing_ok=True)
        self.process = subprocess.Popen(
            ["chromium", "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             "--window-size=1280,800", f"--user-data-dir={profile}", "--remote-debugging-port=0", link],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        end = time.monotonic() + PATIENCE
        while not (port_file.exists() and port_file.read_text().count("\n")):
            if time.monotonic() > end or self.process.poll() is not None:
                raise AssertionError("Chromium does not start")
            time.sleep(0.1)
        self.port = port_file.read_text().split("\n", 1)[0]
        self.page = self.page_at(link)

    def page_at(self, link, kind="page"):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            with urllib.request.urlopen(f"http://127.0.0.1:{self.port}/json/list") as answer:
                for one in json.load(answer):
                    if one["type"] == kind and one["url"].startswith(link.split("#")[0]):
                        return Page(one["webSocketDebuggerUrl"])
            time.sleep(0.1)
        raise AssertionError(f"Chromium does not open {link}")

    def open(self, link):
        """Opens a second page."""
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}/json/new", method="PUT")
        with urllib.request.urlopen(request) as answer:
            page = Page(json.load(answer)["webSocketDebuggerUrl"])
        page.go_to(link)
        return page

    def kill(self):
        """Ends all processes of the browser at once, as a failure of the machine does."""
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()

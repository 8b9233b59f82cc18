"""Chromium, driven through its pipe: what a page does with the hands of a user."""

from __future__ import annotations

import base64
import fcntl
import itertools
import json
import os
import shutil
import subprocess
import time
from pathlib import Path
from typing import Any

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
_QUIET = "--disable-gpu --disable-quic --no-first-run --disable-background-networking --disable-component-update"
_PATIENCE = 300.0  # [s] for what is waited for

_CONTROLS = """
var left = new Set([...document.querySelectorAll("a[href], button, input, select, textarea, summary, [tabindex='0']")]
  .filter((one) => !one.disabled && one.checkVisibility()));
var seen = () => {
  const style = getComputedStyle(document.activeElement);
  if (style.outlineStyle !== "none" && parseFloat(style.outlineWidth) > 0) left.delete(document.activeElement);
};
"""


def _moved(file: int) -> int:
    high = fcntl.fcntl(file, fcntl.F_DUPFD, 10)
    os.close(file)
    return high


class Browser:
    """A window without a screen.

    Args:
        profile: Folder for what it keeps.
        width: Of the window [px].
        height: Of the window [px].
        dark: Whether the user likes it dark.
    """

    def __init__(self, profile: Path, width: int = 1400, height: int = 1000, *, dark: bool = False) -> None:
        hears, self._say = os.pipe()
        self._hear, says = os.pipe()
        # it reads from 3 and writes to 4; the shell moves the ends of the pipes there, from where they are in no way
        hears, says = (_moved(one) for one in (hears, says))
        command = [
            str(CHROMIUM), "--headless", "--no-sandbox", "--remote-debugging-pipe", "--disable-sync", *_QUIET.split(),
            "--hide-scrollbars", f"--user-data-dir={profile}", "about:blank",
        ]  # fmt: skip
        shell = ["bash", "-c", f'exec "$@" 3<&{hears} 4>&{says}', "bash", *command]
        self._process = subprocess.Popen(shell, pass_fds=(hears, says), stderr=subprocess.DEVNULL)
        os.close(hears)
        os.close(says)
        self._numbers = itertools.count(1)
        self._rest = b""
        self.errors: list[str] = []
        self.asked: list[str] = []  # addresses, of all that pages asked for
        (page,) = [one for one in self._ask("Target.getTargets")["targetInfos"] if one["type"] == "page"]
        attached = self._ask("Target.attachToTarget", targetId=page["targetId"], flatten=True)
        self._session: str = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self._ask(f"{domain}.enable")
        self.resize(width, height)
        likes = {"prefers-color-scheme": "dark" if dark else "light", "prefers-reduced-motion": "reduce"}
        features = [{"name": name, "value": value} for name, value in likes.items()]
        self._ask("Emulation.setEmulatedMedia", features=features)

    def __enter__(self) -> Browser:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.kill()
        self._process.wait()
        os.close(self._say)
        os.close(self._hear)

    def resize(self, width: int, height: int) -> None:
        """Make the window another size [px]."""
        self._ask(
            "Emulation.setDeviceMetricsOverride",
            width=width, height=height, deviceScaleFactor=1, mobile=width < 600,
        )  # fmt: skip

    def open(self, address: str) -> None:
        """Go to an address."""
        self._ask("Page.navigate", url=address)

    def run(self, script: str) -> Any:
        """What a script gives."""
        told = self._ask("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in told, told
        return told["result"].get("value")

    def wait(self, condition: str) -> None:
        """Wait until a script says yes."""
        until = time.monotonic() + _PATIENCE
        while not self.run(f"Boolean({condition})"):
            assert time.monotonic() < until, condition
            time.sleep(0.05)

    def type(self, text: str) -> None:
        """Type where the cursor is."""
        self._ask("Input.insertText", text=text)

    def press(self, key: str) -> None:
        """Press a key, by its name."""
        code = {"Enter": 13, "Tab": 9, " ": 32}.get(key, 0)
        text = {"Enter": "\r", " ": " "}.get(key, "")
        self._ask("Input.dispatchKeyEvent", type="keyDown", key=key, code=key, windowsVirtualKeyCode=code, text=text)
        self._ask("Input.dispatchKeyEvent", type="keyUp", key=key, code=key, windowsVirtualKeyCode=code)

    def passed_over(self) -> list[str]:
        """The controls of the page, as markup, that the Tab key does not come to, or that do not show that it did."""
        self.run(_CONTROLS)
        for _ in range(self.run("left.size") + 1):
            self.press("Tab")
            self.run("seen()")
        return self.run("[...left].map((one) => one.outerHTML.slice(0, 120))")

    def cost(self) -> tuple[float, float]:
        """Processor time that the page took so far [s], and the memory of what its scripts hold [MB]."""
        self._ask("Performance.enable")
        self._ask("HeapProfiler.collectGarbage")
        told = {one["name"]: one["value"] for one in self._ask("Performance.getMetrics")["metrics"]}
        return told["TaskDuration"], told["JSHeapUsedSize"] / 1e6

    def picture(self, path: Path, *, whole: bool = False) -> None:
        """Keep what is seen, or the whole page."""
        told = self._ask("Page.captureScreenshot", format="png", captureBeyondViewport=whole)
        path.write_bytes(base64.b64decode(told["data"]))

    def _ask(self, method: str, **params: Any) -> dict[str, Any]:
        number = next(self._numbers)
        session = {"sessionId": self._session} if hasattr(self, "_session") else {}
        os.write(self._say, json.dumps({"id": number, "method": method, "params": params, **session}).encode() + b"\0")
        while True:
            told = self._next()
            if told.get("id") == number:
                assert "error" not in told, told
                return told["result"]
            if told.get("method") == "Network.requestWillBeSent":
                self.asked.append(told["params"]["request"]["url"])
            if told.get("method") in ("Runtime.exceptionThrown", "Log.entryAdded"):
                self.errors.append(json.dumps(told["params"]))

    def _next(self) -> dict[str, Any]:
        while b"\0" not in self._rest:
            read = os.read(self._hear, 2**20)
            assert read, "Chromium ended"
            self._rest += read
        message, _, self._rest = self._rest.partition(b"\0")
        return json.loads(message)

"""Firefox, driven by its own remote protocol, Marionette.

Playwright drives only a Firefox built for it, which no package repository has, and the WebDriver BiDi of Debian's
Firefox lacks a command that it needs. Mozilla's own client loads `telnetlib`, which Python 3.13 has no more.

Source: https://firefox-source-docs.mozilla.org/testing/marionette/Protocol.html
"""

from __future__ import annotations

import json
import shutil
import socket
import subprocess
from collections.abc import Mapping
from pathlib import Path
from time import monotonic, sleep
from typing import Any

FIREFOX = next(filter(None, map(shutil.which, ("firefox-esr", "firefox"))), None)
PATIENCE = 60  # seconds; a busy machine takes its time
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the name under which WebDriver keeps the number of an element
QUIET: Mapping[str, str | int] = {"marionette.port": 0, "datareporting.policy.dataSubmissionEnabled": "false"}
WHEN = """
const [condition, done] = [new Function("return " + arguments[0]), arguments[1]];
const look = () => condition() ? done(true) : setTimeout(look, 10);
look();
"""


class Firefox:
    """A window of Firefox without a screen; its profile is in a folder of its own, downloads beside it.

    >>> with Firefox(folder) as firefox:
    ...     firefox.open("file:///page.html")
    ...     firefox.run("return document.title")
    """

    def __init__(self, folder: Path) -> None:
        assert FIREFOX
        self.folder, self.downloads = folder / "profile", folder / "downloads"
        for each in (self.folder, self.downloads):
            each.mkdir()
        wanted = {**QUIET, "browser.download.folderList": 2, "browser.download.dir": str(self.downloads)}
        lines = (f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in wanted.items())
        (self.folder / "user.js").write_text("\n".join(lines), encoding="utf-8")
        arguments = ("--headless", "--no-remote", "--marionette", "--remote-allow-system-access", "--profile")
        self.process = subprocess.Popen(
            [FIREFOX, *arguments, str(self.folder)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        self.count = 0

    def __enter__(self) -> Firefox:
        self.socket = socket.create_connection(("127.0.0.1", self._port()), 2 * PATIENCE)
        self._heard()  # it says which protocol it speaks
        self.tell("WebDriver:NewSession", capabilities={"alwaysMatch": {"timeouts": {"script": 1000 * PATIENCE}}})
        return self

    def __exit__(self, *_: object) -> None:
        self.socket.close()
        self.process.terminate()
        self.process.wait(PATIENCE)

    def _port(self) -> int:
        """Where it listens, which it writes into its profile when it does."""
        file, end = self.folder / "MarionetteActivePort", monotonic() + PATIENCE
        while monotonic() < end and self.process.poll() is None:
            if file.exists() and (text := file.read_text(encoding="utf-8")):
                return int(text)
            sleep(0.02)
        raise TimeoutError(f"{FIREFOX} does not listen")

    def _heard(self) -> Any:
        """The next message: its length in bytes, a colon, JSON."""
        length = b""
        while not length.endswith(b":"):
            length += self.socket.recv(1)
        text = b""
        while len(text) < int(length[:-1]):
            text += self.socket.recv(int(length[:-1]) - len(text))
        return json.loads(text)

    def tell(self, command: str, **parameters: Any) -> Any:
        """What comes back of a command; RuntimeError with what Firefox says if it cannot be done."""
        self.count += 1
        message = json.dumps([0, self.count, command, parameters]).encode()
        self.socket.sendall(b"%d:%s" % (len(message), message))
        _, _, error, result = self._heard()
        if error:
            raise RuntimeError(f"{command}: {error['message']}")
        return result.get("value") if isinstance(result, dict) else result

    def open(self, address: str) -> None:
        """The page anew, also where only what follows the # is another."""
        self.tell("WebDriver:Navigate", url="about:blank")
        self.tell("WebDriver:Navigate", url=address)

    def run(self, script: str, *arguments: Any) -> Any:
        """What a script returns in the page."""
        return self.tell("WebDriver:ExecuteScript", script=script, args=list(arguments))

    def answer(self, script: str, *arguments: Any) -> Any:
        """With what a script in the page calls the last of its arguments."""
        return self.tell("WebDriver:ExecuteAsyncScript", script=script, args=list(arguments))

    def when(self, condition: str) -> None:
        """Wait until an expression is true in the page."""
        self.answer(WHEN, condition)

    def _element(self, selector: str) -> str:
        return str(self.tell("WebDriver:FindElement", using="css selector", value=selector)[ELEMENT])

    def click(self, selector: str) -> None:
        """As a mouse does: what cannot be seen, or is covered, cannot be clicked."""
        self.tell("WebDriver:ElementClick", id=self._element(selector))

    def type(self, selector: str, text: str) -> None:
        self.tell("WebDriver:ElementSendKeys", id=self._element(selector), text=text)

    def saved(self) -> Path:
        """The file that is downloaded, once it is whole."""
        end = monotonic() + PATIENCE
        while monotonic() < end:
            found = list(self.downloads.iterdir())
            if found and all(each.suffix != ".part" and each.stat().st_size for each in found):
                return found[0]
            sleep(0.02)
        raise TimeoutError("nothing is downloaded")

    def errors(self) -> list[str]:
        """What scripts of files have done wrong."""
        self.tell("Marionette:SetContext", value="chrome")
        found: list[str] = self.run("""const all = Services.console.getMessageArray();
            Services.console.reset();
            return all.filter((each) => each instanceof Ci.nsIScriptError)
                .filter((each) => !(each.flags & Ci.nsIScriptError.warningFlag))
                .filter((each) => each.sourceName.startsWith("file:")).map(String)""")
        self.tell("Marionette:SetContext", value="content")
        return found

"""Install the pinned packages with pip, and say on one line how far it is. Run with the interpreter of the environment.

PYTHON packages.py requirements.lock
"""

import re
import subprocess
import sys
import sysconfig
import threading
import time
from pathlib import Path

from pip._vendor.packaging.requirements import Requirement

EVERY = 8.0
"""Seconds between two lines where there is no terminal."""


def wanted(path: str) -> int:
    """Packages of a lock that this machine needs."""
    pins = re.findall(r"^([\w.-]+==[^\\\n]+)", Path(path).read_text("utf-8"), re.MULTILINE)
    needed = [Requirement(pin.strip()) for pin in pins]
    return sum(one.marker is None or one.marker.evaluate() for one in needed)


def main() -> int:
    """Install; the exit code is pip's."""
    lock = sys.argv[1]
    pip, said = Pip(wanted(lock)), []
    options = ["--disable-pip-version-check", "--progress-bar", "off", "--require-hashes", "-r", lock]
    with subprocess.Popen([sys.executable, "-m", "pip", "install", *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True) as process:  # fmt: skip
        threading.Thread(target=pip.show, daemon=True).start()
        for line in process.stdout:
            said.append(line)
            pip.read(line)
    pip.end()
    if process.returncode:
        sys.stderr.writelines(said)
    return process.returncode


class Pip:
    """How far pip is: packages are fetched one after the other, then unpacked, which pip itself does in silence.

    count : of packages.
    """

    def __init__(self, count: int) -> None:
        self.count, self.fetched, self.had, self.now, self.unpacks = count, 0, 0, "", False
        self.began, self.over = time.monotonic(), threading.Event()
        self.before = self.there()

    def read(self, line: str) -> None:
        """A line that pip prints."""
        if found := re.match(r"(?:Collecting|Processing|Requirement already satisfied:) (?:\S*/)?(\w[\w.]*?)[-= ]", line):
            self.fetched, self.now = min(self.fetched + 1, self.count), found[1]
            self.had += line.startswith("Requirement")
        self.unpacks |= line.startswith("Installing")

    def there(self) -> int:
        """Packages in this environment."""
        return len(list(Path(sysconfig.get_path("purelib")).glob("*.dist-info")))

    def text(self) -> str:
        """How far it is."""
        seconds = f"{time.monotonic() - self.began:.0f} s"
        if self.unpacks:
            return f"  packages: unpacked {self.had + self.there() - self.before} of {self.count}, {seconds}"
        return f"  packages: {self.fetched} of {self.count} ({self.now or 'pip starts'}), {seconds}"

    def show(self) -> None:
        """A line that stays in its place on a terminal; elsewhere one now and then."""
        terminal = sys.stdout.isatty()
        while not self.over.wait(0.5 if terminal else EVERY):
            print(f"\r{self.text():<70}" if terminal else self.text(), end="" if terminal else "\n", flush=True)

    def end(self) -> None:
        """The last line."""
        self.over.set()
        print(f"\r{self.text():<70}" if sys.stdout.isatty() else self.text(), flush=True)


if __name__ == "__main__":
    sys.exit(main())

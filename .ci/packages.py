"""Install the pinned packages with pip, and say on one line how far it is. Run with the interpreter of the environment.

PYTHON packages.py requirements.lock
"""

import re
import subprocess
import sys
from pathlib import Path

from pip._vendor.packaging.requirements import Requirement


def wanted(path: str) -> int:
    """Packages of a lock that this machine needs."""
    pins = re.findall(r"^([\w.-]+==[^\\\n]+)", Path(path).read_text("utf-8"), re.MULTILINE)
    needed = [Requirement(pin.strip()) for pin in pins]
    return sum(one.marker is None or one.marker.evaluate() for one in needed)


def main() -> int:
    """Install; the exit code is pip's."""
    lock = sys.argv[1]
    count, seen, said = wanted(lock), 0, []
    options = ["--disable-pip-version-check", "--progress-bar", "off", "--require-hashes", "-r", lock]
    with subprocess.Popen([sys.executable, "-m", "pip", "install", *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True) as pip:  # fmt: skip
        for line in pip.stdout:
            said.append(line)
            if found := re.match(r"(?:Collecting|Processing|Requirement already satisfied:) (?:\S*/)?(\w[\w.]*?)[-= ]", line):
                seen += 1
                tell(f"  packages: {min(seen, count)} of {count} ({found[1]})", last=seen >= count)
            elif line.startswith("Installing"):
                print("  unpacking them ...", flush=True)
    if pip.returncode:
        sys.stderr.writelines(said)
    return pip.returncode


def tell(text: str, last: bool) -> None:
    """A line that stays in its place on a terminal; elsewhere every twentieth."""
    if sys.stdout.isatty():
        print(f"\r{text:<60}", end="\n" if last else "", flush=True)
    elif last or re.search(r"\b\d*[02468]0 of", text):
        print(text, flush=True)


if __name__ == "__main__":
    sys.exit(main())

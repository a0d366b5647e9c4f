"""A studio in a process of its own, on a free port of this machine."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from kinetruss import io

WAIT = 60.0  # s, for a machine that is busy with other things


@dataclass
class Served:
    """A studio that listens."""

    process: subprocess.Popen[str]
    address: str
    folder: Path

    @property
    def host(self) -> str:
        return self.address.split("/")[2]

    @property
    def live(self) -> str:
        return self.address.replace("http", "ws", 1) + "live"

    @property
    def origin(self) -> str:
        return f"http://{self.host}"

    def stop(self) -> int:
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(WAIT)


def serve(model, folder: Path) -> Served:
    """Start a studio of a model whose file is in a folder; of an empty drawing if there is no model."""
    given = [] if model is None else [str(io.write(model, folder / "model.yaml"))]
    return start(folder, *given)


def start(folder: Path, *arguments: str) -> Served:
    """Start a studio with arguments of the command line; it may write into a folder."""
    code = "from kinetruss.cli import main; main()"
    command = [sys.executable, "-c", code, "studio", *arguments, "--no-open", "--folder", str(folder)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    return Served(process, re.search(r"http://\S+", process.stdout.readline())[0], folder)

"""A code as a process that answers questions."""

from __future__ import annotations

import json
import os
import select
import subprocess
from pathlib import Path

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS", "BLIS_NUM_THREADS")


class Worker:
    """`_worker.py` for one code under an interpreter, on one thread; started again when it dies or takes over `patience` s."""

    def __init__(self, code: str, python: str, patience: float) -> None:
        self.code, self.python, self.patience = code, python, patience
        self.process: subprocess.Popen | None = None

    def ask(self, **question) -> dict:
        """The answer, or {"failed": why}."""
        if self.process is None or self.process.poll() is not None:
            self._start()
        try:
            self.process.stdin.write(json.dumps(question) + "\n")
            self.process.stdin.flush()
            ready, _, _ = select.select([self.process.stdout], [], [], self.patience)
            line = self.process.stdout.readline() if ready else ""
        except BrokenPipeError:
            line, ready = "", True
        if line:
            return json.loads(line)
        self.close()
        return {"failed": "the process ended" if ready else f"no answer in {self.patience:g} s"}

    def _start(self) -> None:
        command = [self.python, str(Path(__file__).resolve().parent / "_worker.py"), self.code]
        env = os.environ | dict.fromkeys(THREADS, "1")
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=env
        )

    def close(self) -> None:
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.process = None

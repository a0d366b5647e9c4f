"""Prints a page to PDF by a browser without a window."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

__all__ = ["chromium", "print_page"]

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge", "msedge")
PLACES = ("/Applications/Google Chrome.app/Contents/MacOS/Google Chrome", "/Applications/Chromium.app/Contents/MacOS/Chromium")
PATIENCE = 180.0
"""Largest time of printing, s."""

FLAGS = (
    "--headless=new",
    "--disable-gpu",
    "--no-first-run",
    "--no-default-browser-check",
    "--no-pdf-header-footer",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-extensions",
    "--disable-sync",
    "--host-resolver-rules=MAP * ~NOTFOUND",
)
"""Options without network access: the page needs none, and the browser must not use any."""


def chromium() -> str | None:
    """The program that prints, or None if there is none."""
    for name in NAMES:
        if found := shutil.which(name):
            return found
    return next((place for place in PLACES if Path(place).is_file()), None)


def print_page(page: Path, paper: Path, scratch: Path) -> str:
    """Print an HTML file to a PDF file. Returns an empty text, or a sentence with the reason of a failure and the fix.

    scratch : folder for temporary files of the browser.
    """
    program = chromium()
    if program is None:
        return "No PDF: no Chromium was found. Install it (Debian: apt-get install chromium), or print the page from a browser."
    flags = list(FLAGS)
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        flags.append("--no-sandbox")  # needed to start as root; the page is our own
    command = [program, *flags, f"--user-data-dir={scratch}", f"--print-to-pdf={paper}", page.resolve().as_uri()]
    try:
        done = subprocess.run(command, capture_output=True, timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        return f"No PDF: {program} did not print the page within {PATIENCE:g} s. Print it from a browser."
    except OSError as error:
        return f"No PDF: {program} cannot be started ({error.strerror}). Print the page from a browser."
    if done.returncode == 0 and _is_whole(paper):
        return ""
    said = done.stderr.decode(errors="replace").strip().splitlines()
    last = said[-1] if said else f"exit code {done.returncode}"
    return f"No PDF: {program} failed ({last}). Print the page from a browser."


def _is_whole(paper: Path) -> bool:
    if not paper.is_file():
        return False
    data = paper.read_bytes()
    return data.startswith(b"%PDF-") and b"%%EOF" in data[-64:]

"""Every command that shows a run, of whatever analysis."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from click.testing import CliRunner

from kinetruss.cli import main


def shown(run: Path, to: Path) -> tuple[str, dict[str, Any]]:
    """The page of its report, and what `info --json` says."""
    told = ""
    for words in (
        "view RUN -o TO/view.html", "plot RUN --quantity member_force -o TO/plot.png", "export RUN TO/all.csv",
        "compare RUN RUN", "info RUN", "report RUN -o TO/report --no-open --no-pdf", "info RUN --json",
    ):  # fmt: skip
        done = CliRunner().invoke(main, [one.replace("RUN", str(run)).replace("TO", str(to)) for one in words.split()])
        assert done.exit_code == 0, (words, done.output)
        told = done.stdout
    return (to / "report" / "report.html").read_text("utf-8"), json.loads(told)

"""The command line of a probe: answers all cases of a seed into a folder."""

from __future__ import annotations

import argparse
import json
import time
import warnings
from collections.abc import Callable
from pathlib import Path

import models
from answers import Answer, answer_all
from covers import covers
from models import Case

import kinetruss as kt


def main(assembled: Callable[[Case, Answer], None]) -> int:
    """Answer cases and runs; says in a file where the package came from."""
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    for name in ("seed", "count", "runs"):
        parser.add_argument(f"--{name}", type=int, required=True)
    parser.add_argument("--conditions", action="store_true", help="also find how sure solved answers are")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    (given.folder / "from.json").write_text(json.dumps({"package": str(Path(kt.__file__).parent)}))
    warnings.simplefilter("ignore")  # of ill-conditioned random models; what comes of them is compared
    began = time.process_time()

    def of_case(number: int) -> Answer:
        case = models.case(given.seed, number)
        answer = Answer(number, case.name, case.fingerprint, covers(case))
        assembled(case, answer)
        return answer

    def of_run(number: int) -> Answer:
        from solved import run

        return run(given.seed, number, given.conditions)

    answer_all(given.folder, "cases", given.count, of_case)
    answer_all(given.folder, "runs", given.runs, of_run)
    (given.folder / f"whole-{given.count}-{given.runs}").touch()
    print(f"{time.process_time() - began:.0f} s of processor time")
    return 0

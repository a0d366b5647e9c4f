"""Run the quick tests of one part, or of the parts that a change touches: those that are not marked as slow.

    .venv/bin/python tests/quick.py [PART]

A part is a package of src/kinetruss, `package` what stands beside them there, `project` what concerns the whole. Without PART:
the parts of the files that are not committed, or, where all are, of the last commit. Property tests try fewer examples.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

ROOT = Path(__file__).parents[1]
PARTS = {
    "actuators": ("actuators",),
    "cli": ("cli",),
    "design": ("design",),
    "display": ("display",),
    "dynamics": ("dynamics",),
    "exchange": ("exchange",),
    "flexible": ("flexible",),
    "gradients": ("gradients",),
    "io": ("io",),
    "kernels": ("kernels", "rows"),
    "elements": ("elements",),
    "kinematics": ("kinematics", "tasks"),
    "library": ("library",),
    "mechanics": ("bodies", "joints", "solids"),
    "model": ("model",),
    "notebook": ("notebook",),
    "package": ("units",),
    "project": ("acceptance", "bench", "campaigns", "docs", "gates"),
    "report": ("report",),
    "results": ("runs",),
    "runs": ("runs", "conditions"),
    "statics": ("statics",),
    "strength": ("strength",),
    "studies": ("studies",),
    "studio": ("studio",),
    "verification": ("verification",),
    "viewer": ("viewer", "browser", "render"),
}
"""Folders of tests of each part."""


def touched(files: Iterable[str]) -> list[str]:
    """The parts to which files belong, by their paths in the project."""
    found = set()
    for file in files:
        match Path(file).parts:
            case ("src", "kinetruss", part, *inner):
                found.add(part if inner else "package")
            case ("tests", folder, _, *_):
                found |= {part for part, folders in PARTS.items() if folder in folders}
    return sorted(found & PARTS.keys())


def changed(root: Path = ROOT) -> list[str]:
    """Files that are not committed as they are; where there are none, those of the last commit."""
    for command in (
        (("ls-files", "--others", "--exclude-standard"), ("diff", "--name-only", "HEAD")),
        (("diff-tree", "--no-commit-id", "--name-only", "-r", "--root", "HEAD"),),
    ):
        lines = [subprocess.run(["git", *one], cwd=root, check=True, capture_output=True, text=True).stdout for one in command]
        if files := "".join(lines).split("\n")[:-1]:
            return files
    return []


def main(arguments: Sequence[str]) -> int:
    """Run the tests; the exit code of pytest."""
    if unknown := [part for part in arguments if part not in PARTS]:
        print(f"No part {unknown[0]!r}. Parts: {', '.join(PARTS)}.", file=sys.stderr)
        return 2
    parts = list(arguments) or touched(changed())
    if not parts:
        print("The change touches no part.")
        return 0
    print(f"Quick tests of {', '.join(parts)}", flush=True)
    folders = [str(ROOT / "tests" / one) for one in dict.fromkeys(one for part in parts for one in PARTS[part])]
    # plugins that other packages bring along take longer to start than many tests
    environment = os.environ | {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
    options = ["-q", "-m", "not slow", "-p", "_hypothesis_pytestplugin", "--hypothesis-profile=quick"]
    return subprocess.run([sys.executable, "-m", "pytest", *options, *folders], cwd=ROOT, env=environment).returncode


if __name__ == "__main__":
    sys.exit(main([one for one in sys.argv[1:] if one]))

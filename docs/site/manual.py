"""The verification manual: every entry of `kinetruss verify`, computed when the site is built."""

import itertools
from typing import Any

from kinetruss.display import number
from kinetruss.verification import verify


def pages() -> list[tuple[str, str]]:
    """The overview and a page for each group of cases."""
    entries = sorted(verify().entries, key=lambda entry: entry.id)
    if missed := [entry.id for entry in entries if not entry.passed]:
        raise RuntimeError(f"The site is not built: these values do not agree: {', '.join(missed)}")
    groups = {key: list(found) for key, found in itertools.groupby(entries, lambda entry: entry.id.split(".")[0])}
    lines = ["# Verification manual", "", f"{len(entries):,} values, each computed on the machine that built this site.", ""]
    lines += ["| group | entries | passed | largest difference / tolerance |", "|---|---|---|---|"]
    for name, found in groups.items():
        worst = max((one.relative_difference / one.tolerance for one in found if one.tolerance), default=0.0)
        lines.append(f"| [{name}]({name}.md) | {len(found)} | {sum(one.passed for one in found)} | {number(worst, 2)} |")
    lines += ["", "```{toctree}", ":hidden:", "", *groups, "```", ""]
    return [
        ("manual/index.md", "\n".join(lines)),
        *((f"manual/{name}.md", _group(name, found)) for name, found in groups.items()),
    ]


def _group(name: str, entries: list[Any]) -> str:
    lines = [
        f"# Verification: {name}",
        "",
        "| entry | expected | computed | difference | tolerance | class | source |",
        "|---|---|---|---|---|---|---|",
    ]
    for one in entries:
        cells = (one.id, number(one.expected, 10), number(one.computed, 10), number(one.relative_difference, 2),
                 number(one.tolerance, 2), one.kind, one.source)  # fmt: skip
        lines.append("| " + " | ".join(str(cell).replace("|", "\\|").replace("\n", " ") for cell in cells) + " |")
    return "\n".join([*lines, ""])

"""The API reference: one page for each public package, from signatures and docstrings."""

import inspect
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import kinetruss as kt

PACKAGES = {
    "model": "Nodes, bars, drives, loads, runs: the classes of a model",
    "library": "Ready-made trusses, mechanisms, materials, drives",
    "kinematics": "How does it move?",
    "dynamics": "What forces does the motion need? How does it move under forces?",
    "statics": "Equilibrium, linear deflection, buckling, paths",
    "flexible": "What if it is elastic?",
    "strength": "Is it strong enough?",
    "actuators": "What must screws, gears and motors provide?",
    "design": "Which sections and drives?",
    "runs": "Runs, missions, error budgets, stored results",
    "results": "Motions, forces, verdicts: datasets with names and units",
    "report": "Reports, tables, pictures",
    "viewer": "Pages and films",
    "studio": "The live page",
    "notebook": "In notebooks",
    "io": "Files",
    "exchange": "Files of other programs",
    "units": "Units in text",
    "verification": "Comparison with references",
    "errors": "What can go wrong",
}
"""Public packages in the order of the reference -> their question."""

FIRST = ("Model", "Node", "Bar", "Active", "Body", "Beam")
"""Names that stand before those in the order of the alphabet."""
SECTIONS = ("Parameters", "Returns", "Raises", "Notes", "Examples", "Yields", "See also")
SECTION = re.compile(rf"^({'|'.join(SECTIONS)})\n-+$", re.MULTILINE)
FIELD = re.compile(r"^([A-Za-z_][\w., */]*) : ")


def pages(_made: Path) -> Iterator[tuple[str, str]]:
    """Name and text of every page."""
    found = {name: question for name, question in PACKAGES.items() if name in kt.__all__}
    lines = ["# API reference", "", "```{toctree}", ":maxdepth: 1", "", *(f"{name}" for name in found), "```", ""]
    lines += [
        "Nouns (`kt.Model`, `kt.Bar`, ...) are also names of `kinetruss` itself. In all examples: `import kinetruss as kt`.",
        "",
    ]
    yield "api/index.md", "\n".join(lines)
    for name, question in found.items():
        yield f"api/{name}.md", _page(name, question)


def _page(name: str, question: str) -> str:
    module = getattr(kt, name)
    asked = question if question.endswith("?") else f"{question}."
    lines = [f"# kt.{name}", "", asked, "", *text_of(inspect.getdoc(module) or ""), ""]
    kinds = (("Functions", inspect.isroutine), ("Records", inspect.isclass))
    for what, test in reversed(kinds) if name == "model" else kinds:  # what one writes with comes first
        names = sorted(module.__all__, key=lambda key: (FIRST.index(key) if key in FIRST else len(FIRST), key.lower()))
        chosen = [(key, one) for key in names if test(one := getattr(module, key))]
        lines += [f"## {what}", ""] if chosen else []
        for key, one in chosen:
            lines += _entry(f"{name}.{key}", key, one)
    for key in sorted(module.__all__):
        if inspect.ismodule(part := getattr(module, key)):
            lines += [f"## {name}.{key}", "", *text_of(inspect.getdoc(part) or ""), ""]
            for word in getattr(part, "__all__", ()):
                if inspect.isfunction(one := getattr(part, word)):
                    lines += _entry(f"{name}.{key}.{word}", f"{name}.{key}.{word}", one)
    return "\n".join(lines)


def _entry(name: str, heading: str, one: Any) -> list[str]:
    """One function or record: anchor, heading, signature, text. Anchors do not tell capitals, so records have their own."""
    anchor = f"({name}.record)=" if inspect.isclass(one) else f"({name})="
    return [anchor, f"### {heading}", "", *_signature(f"kt.{name}", one), *text_of(inspect.getdoc(one) or ""), ""]


def _signature(name: str, one: Any) -> list[str]:
    try:
        signature = inspect.signature(one)
    except (TypeError, ValueError):
        return []
    empty = inspect.Parameter.empty
    plain = [parameter.replace(annotation=empty) for parameter in signature.parameters.values()]
    text = f"{name}{signature.replace(parameters=plain, return_annotation=empty)}"
    if len(text) > 100:
        text = text.replace("(", "(\n    ", 1).replace(", ", ",\n    ")
        text = f"{text[:-1]},\n)"
    return ["```python", re.sub(r"<([\w.]+)[^>]*>", r"\1", text), "```", ""]


def text_of(doc: str) -> list[str]:
    """A docstring as Markdown: sections as bold words, fields as lists, examples as code."""
    doc = SECTION.sub(r"\n\1:\n", doc)
    lines: list[str] = []
    for block in re.split(r"\n\s*\n", doc.strip()):
        if (head := block.strip().rstrip(":")) in SECTIONS and block.strip().endswith(":"):
            lines += [f"**{head}**", ""]
        elif re.match(r"\s*>>>", block):
            lines += ["```pycon", inspect.cleandoc(block), "```", ""]
        elif all(line.startswith("    ") for line in block.split("\n")):
            lines += ["```text", inspect.cleandoc(block), "```", ""]
        else:
            lines += [*_block(block), ""]
    return lines


def _block(block: str) -> Iterator[str]:
    example: list[str] = []
    for line in block.split("\n"):
        if example or line.lstrip().startswith(">>> "):
            example.append(line)
        elif found := FIELD.match(line):
            yield f"- `{found[1]}`: {_escaped(line[found.end() :])}"
        else:
            yield _escaped(line) if not line.startswith("    ") else f"  {_escaped(line.strip())}"
    if example:
        yield from ("", "```pycon", inspect.cleandoc("\n".join(example)), "```")


def _escaped(text: str) -> str:
    """Text whose signs Markdown shows as they are; code stays code."""
    parts = re.split(r"(``[^`]*``|`[^`]*`)", text)
    return "".join(
        re.sub(r"([*$<|\\_])", r"\\\1", part) if k % 2 == 0 else f"`{part.strip('`')}`" for k, part in enumerate(parts)
    )

"""Pictures of the parts of docs/parts.md, drawn from the code beside them."""

from __future__ import annotations

import ast
import contextlib
import hashlib
import re
from collections.abc import Iterator
from pathlib import Path

import signs

import kinetruss as kt

PAGE = Path(__file__).parents[1] / "parts.md"
PIECE = re.compile(r"!\[[^\]]*\]\(made/parts/(\w+)\.svg\)|^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
"""A picture, or a block of code."""


def models(text: str) -> Iterator[tuple[str, kt.Model]]:
    """The name of each picture, and the model that the code after it ends with. Blocks run one after the other."""
    names: dict[str, object] = {}
    picture = ""
    for found in PIECE.finditer(text):
        if found[1]:
            picture = found[1]
            continue
        tree = ast.parse(found[2])
        last = tree.body.pop() if picture else None
        exec(compile(tree, str(PAGE), "exec"), names)
        if last is not None:
            model = eval(compile(ast.Expression(last.value), str(PAGE), "eval"), names) if isinstance(last, ast.Expr) else None
            if not isinstance(model, kt.Model):
                raise TypeError(f"{PAGE.name}: the code under {picture}.svg does not end with a model")
            yield picture, model
            picture = ""


def write(folder: Path, key: str) -> None:
    """All pictures, if the page or what it is computed with (its `key`) has changed."""
    text, mark = PAGE.read_text("utf-8"), folder / "key"
    now = f"{key} {hashlib.sha256(text.encode()).hexdigest()}"
    if mark.is_file() and mark.read_text("utf-8") == now:
        return
    folder.mkdir(parents=True, exist_ok=True)
    with contextlib.redirect_stdout(None):  # what the page prints
        for name, model in models(text):
            (folder / f"{name}.svg").write_text(signs.drawn(model), "utf-8")
    mark.write_text(now, "utf-8")

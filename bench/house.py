"""How large and how tangled the source is: the countable figures of the house (``--json`` for one object).

``--root DIR`` counts another checkout, for a comparison. Counts text and imports only; nothing is imported or run.
"""

from __future__ import annotations

import argparse
import ast
import io
import json
import re
import statistics
import tokenize
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

BUILDERS = ("library",)  # functions whose arguments are what a user describes
PRAGMA = re.compile(r"#\s*(noqa|type:|fmt:|pragma|pylint|mypy:|ruff:|isort:|!)")
LAYOUT = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[1], help="checkout to count")
    options = parser.parse_args()
    found = figures(options.root / "src" / "kinetruss")
    if options.json:
        print(json.dumps(found, indent=1))
        return
    for name, value in found.items():
        print(f"{name:42s} {value}")


@dataclass(frozen=True)
class Source:
    """One file: its module, its room (the folder; a folder's `__init__` is no room's file), its text and its tree."""

    path: Path
    module: str
    text: str

    @property
    def package(self) -> str:
        return f"{self.module}.kinetruss".split(".")[1]

    @property
    def room(self) -> str:
        return self.module if self.path.name == "__init__.py" else self.module.rpartition(".")[0]

    @cached_property
    def tree(self) -> ast.Module:
        return ast.parse(self.text)

    @cached_property
    def nodes(self) -> dict[type[ast.AST], list[Any]]:
        """All nodes of the tree, by their kind."""
        found = defaultdict(list)
        for node in ast.walk(self.tree):
            found[type(node)].append(node)
        return found

    @cached_property
    def lines(self) -> int:
        return len(self.text.splitlines())

    @cached_property
    def tokens(self) -> list[tokenize.TokenInfo]:
        return list(tokenize.generate_tokens(io.StringIO(self.text).readline))

    def comments(self, pragmas: bool) -> int:
        """Pragmas, which only a tool reads, or all other comments."""
        return sum(token.type == tokenize.COMMENT and bool(PRAGMA.match(token.string)) == pragmas for token in self.tokens)

    def code(self) -> int:
        """Tokens without comments, docstrings (a text that is a statement) and layout."""
        words = [token for token in self.tokens if token.type not in LAYOUT]
        first = {token.start[0]: token for token in reversed(words)}
        texts = {node.lineno: node for node in self.nodes[ast.Expr] if _is_text(node.value)}
        return len(words) - sum(first[line].type == tokenize.STRING for line in texts)

    def head(self) -> int:
        """Lines before the first definition; of a file without one, none."""
        found = [node for node in self.tree.body if isinstance(node, ast.FunctionDef | ast.ClassDef)]
        return min((one.lineno - 1 for node in found[:1] for one in (node, *node.decorator_list)), default=0)


def sources(root: Path) -> list[Source]:
    """All files below a folder."""
    paths = (path for path in sorted(root.rglob("*.py")) if "__pycache__" not in path.parts)
    return [Source(path, _module(root, path), path.read_text("utf-8")) for path in paths]


def figures(root: Path) -> dict[str, Any]:
    """Every figure by name; paths and functions where a largest one is counted."""
    files = sources(root)
    kernels = [file for file in files if file.package == "kernels"]
    lines = sum(file.lines for file in files)
    arguments, privates = sorted(_arguments(files), reverse=True), _privates(files)
    tokens: Counter[str] = Counter()
    for file in files:
        tokens[file.package] += file.code()
    return {
        "files": len(files),
        "lines": lines,
        "lines of a file, median": statistics.median(file.lines for file in files),
        "lines of the longest file": max(file.lines for file in files),
        "lines before the first definition, %": round(100 * sum(file.head() for file in files) / lines, 1),
        "import circles": [" ".join(circle) for circle in circles(imports(files))],
        "import circles with imports for types": [" ".join(circle) for circle in circles(imports(files, types=True))],
        "pairs of rooms that import each other": len(_pairs(files)),
        "private functions": len(privates),
        "private functions with one caller": sum(count == 1 for count in privates.values()),
        "most arguments outside builders": "{} in {}".format(*arguments[0]),
        "functions with 9 arguments or more": sum(count > 8 for count, _ in arguments),
        "private imports across packages": private_imports(files),
        "exported names": len(_exported(files)),
        "comments per 100 lines": round(100 * sum(file.comments(pragmas=False) for file in files) / lines, 2),
        "pragmas": sum(file.comments(pragmas=True) for file in files),
        "lines of kernels": sum(file.lines for file in kernels),
        "tokens of code": sum(tokens.values()),
        "tokens of code by package": dict(tokens.most_common()),
    }


def _is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def _module(root: Path, file: Path) -> str:
    parts = file.relative_to(root.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _arguments(files: list[Source]) -> Iterator[tuple[int, str]]:
    for file in files:
        for node in file.nodes[ast.FunctionDef] if file.package not in BUILDERS else ():
            every = (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)
            yield sum(one.arg not in ("self", "cls") for one in every), f"{file.module}:{node.name}"


def _privates(files: list[Source]) -> Counter[str]:
    """Private functions of modules -> how often their names are used in the module, or imported from it."""
    found: Counter[str] = Counter()
    for file in files:
        own = {node.name for node in file.tree.body if isinstance(node, ast.FunctionDef) and node.name.startswith("_")}
        found.update({f"{file.module}.{name}": 0 for name in own})
        used = (node.id for node in file.nodes[ast.Name] if node.id in own)
        found.update(f"{file.module}.{name}" for name in used)
    for file in files:
        for node in file.nodes[ast.ImportFrom]:
            found.update(place for one in node.names if (place := f"{node.module}.{one.name}") in found)
    return found


def _asked(file: Source, types: bool) -> Iterator[tuple[str, str]]:
    """Module and name of every import of the house, those within functions too. A face's imports are never done: its names
    are imported at first use."""
    blocks = (node for node in file.nodes[ast.If] if _for_types(node))
    left_out = not types or file.path.name == "__init__.py"
    skipped = {id(node) for block in blocks for node in ast.walk(block)} if left_out else set()
    for node in file.nodes[ast.ImportFrom]:
        if (node.module or "").split(".")[0] == "kinetruss" and id(node) not in skipped:
            yield from ((str(node.module), one.name) for one in node.names)


def _for_types(node: ast.If) -> bool:
    return isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"


def _is_private(file: Source, asked: tuple[str, str]) -> bool:
    """Does it ask another package for a name, or a module, with an underscore? Kernels are not counted."""
    package, *names = [*asked[0].split("."), asked[1]][1:]
    hidden = any(name.startswith("_") and not name.startswith("__") for name in names)
    return hidden and package not in (file.package, "kernels")


def private_imports(files: list[Source]) -> int:
    """How often files ask other packages for what these keep to themselves."""
    return sum(_is_private(file, one) for file in files for one in _asked(file, types=True))


def imports(files: list[Source], types: bool = False) -> dict[str, set[str]]:
    """Modules that each module names in its imports."""
    modules = {file.module for file in files}
    return {
        file.module: {inner if (inner := f"{module}.{name}") in modules else module for module, name in _asked(file, types)}
        & (modules - {file.module})
        for file in files
    }


def _pairs(files: list[Source]) -> set[frozenset[str]]:
    """Folders whose files import each other."""
    rooms = {file.module: file.room for file in files}
    edges: defaultdict[str, set[str]] = defaultdict(set)
    for module, wanted in imports([file for file in files if file.path.name != "__init__.py"]).items():
        edges[rooms[module]] |= {rooms[one] for one in wanted} - {rooms[module]}
    return {frozenset((room, other)) for room in edges for other in edges[room] if room in edges.get(other, ())}


def circles(graph: dict[str, set[str]]) -> list[list[str]]:
    """Strongly connected components of more than one module (Tarjan, 1972)."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    found = []

    def visit(module: str) -> None:
        index[module] = low[module] = len(index)
        stack.append(module)
        for other in sorted(graph[module]):
            if other not in index:
                visit(other)
                low[module] = min(low[module], low[other])
            elif other in stack:
                low[module] = min(low[module], index[other])
        if low[module] == index[module]:
            ring = [stack.pop()]
            while ring[-1] != module:
                ring.append(stack.pop())
            if len(ring) > 1:
                found.append(sorted(ring))

    for module in sorted(graph):
        if module not in index:
            visit(module)
    return found


def _exported(files: list[Source]) -> set[str]:
    """``package.name`` of what the faces of the public packages list, and of what the top level has."""
    faces = {
        file.module: _listed(file.tree) for file in files if file.path.name == "__init__.py" or file.module.count(".") == 1
    }
    top = {name for name in faces["kinetruss"] if f"kinetruss.{name}" in faces}
    return {f"{package}.{name}" for package in top for name in faces[f"kinetruss.{package}"]} | (faces["kinetruss"] - top)


def _listed(tree: ast.Module) -> set[str]:
    """Names in the `__all__` of a module that lists them as they are, or imported by its face (`a as a`)."""
    found = {
        one.asname
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and _for_types(node)
        for part in node.body
        if isinstance(part, ast.ImportFrom)
        for one in part.names
        if one.asname
    }
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.List) and ast.unparse(node.targets[0]) == "__all__":
            found |= {one.value for one in node.value.elts if isinstance(one, ast.Constant) and isinstance(one.value, str)}
    return found


if __name__ == "__main__":
    main()

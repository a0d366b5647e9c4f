"""How large and how tangled the source is: the countable figures of the house (``--json`` for one object).

``--root DIR`` counts another checkout, for a comparison. Counts text and imports only; nothing is imported or run.
"""

from __future__ import annotations

import argparse
import ast
import io
import json
import re
import tokenize
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

BUILDERS = ("library",)  # functions whose arguments are what a user describes
PRAGMA = re.compile(r"#\s*(noqa|type:|fmt:|pragma|pylint|mypy:|ruff:|isort:|!)")


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
        print(f"{name:36s} {value}")


def figures(root: Path) -> dict[str, Any]:
    """Every figure by name; paths and functions where a largest one is counted."""
    files = sorted(root.rglob("*.py"))
    texts = {file: file.read_text("utf-8") for file in files}
    trees = {file: ast.parse(text) for file, text in texts.items()}
    folders = Counter(file.parent for file in files if file.name != "__init__.py")
    folder, most = folders.most_common(1)[0]
    arguments = sorted(_arguments(root, trees), reverse=True)
    public = _public(root, trees)
    inner = [one for one in arguments if one[1].rsplit(":")[-1] not in public]
    circles = _circles(_imports(root, trees))
    comments = {file: _comments(text) for file, text in texts.items()}
    inner_files = [file for file in files if "kernels" in file.relative_to(root).parts]
    return {
        "files": len(files),
        "lines": sum(len(text.splitlines()) for text in texts.values()),
        "files in the largest folder": f"{most} in {folder.relative_to(root)}",
        "folders with more than 12 files": sum(count > 12 for count in folders.values()),
        "import circles": len(circles),
        "files in import circles": sum(map(len, circles)),
        "most arguments outside builders": "{} in {}".format(*arguments[0]),
        "most arguments of an inner function": "{} in {}".format(*inner[0]),
        "functions with 9 arguments or more": sum(count > 8 for count, _ in arguments),
        "places numbered by integers": len(_numbered([tree for file, tree in trees.items() if "kernels" in file.parts])),
        "inner modules imported across packages": _across(root, trees),
        "private imports across packages": _private(root, trees),
        "exported names": len(_exported(root, trees)),
        "comments per 100 lines": _share(comments, texts, files),
        "comments per 100 lines of kernels": _share(comments, texts, inner_files),
        "pragmas": sum(pragmas for _, pragmas in comments.values()),
        "lines of kernels": sum(len(text.splitlines()) for file, text in texts.items() if "kernels" in file.parts),
    }


def _arguments(root: Path, trees: dict[Path, ast.Module]) -> list[tuple[int, str]]:
    found = []
    for file, tree in trees.items():
        if file.relative_to(root).parts[0] in BUILDERS:
            continue
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef):
                names = [
                    a.arg
                    for a in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)
                    if a.arg not in ("self", "cls")
                ]
                found.append((len(names), f"{file.relative_to(root)}:{node.name}"))
    return found


def _public(root: Path, trees: dict[Path, ast.Module]) -> set[str]:
    """Names that a package declares, and commands: their arguments are what a user may ask for."""
    found: set[str] = set()
    for file, tree in trees.items():
        if file.parent.parent == root and file.name == "__init__.py":
            found |= _declared(tree)
        for node in tree.body:
            if isinstance(node, ast.FunctionDef) and any("command" in ast.unparse(one) for one in node.decorator_list):
                found.add(node.name)
    return found


def _numbered(trees: list[ast.Module]) -> set[str]:
    """Names of integers (NAME = 3; A, B, C = range(3) or 0, 1, 2) by which compiled functions index, x[NAME] or x[m.NAME + 1].

    Names are matched as words, whatever module they are of; one that reaches the brackets by another name is not seen. Limits,
    counts and kinds that are only compared, or that only tell how large something is, are no places and do not count.
    """
    return {name for tree in trees for name in _integers(tree)} & {name for tree in trees for name in _indices(tree)}


def _integers(tree: ast.Module) -> Iterator[str]:
    """Names in the module itself that stand for integers."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and _whole(node.value):
            yield from (name.id for target in node.targets for name in ast.walk(target) if isinstance(name, ast.Name))


def _whole(value: ast.expr) -> bool:
    if isinstance(value, ast.Tuple):
        return all(map(_whole, value.elts))
    if isinstance(value, ast.Call):
        return isinstance(value.func, ast.Name) and value.func.id == "range"
    return isinstance(value, ast.Constant) and isinstance(value.value, int)


def _indices(tree: ast.Module) -> Iterator[str]:
    """Names within brackets in functions whose decorators begin with `kernel`."""
    for function in ast.walk(tree):
        if isinstance(function, ast.FunctionDef) and any(map(_compiles, function.decorator_list)):
            for node in ast.walk(function):
                for part in ast.walk(node.slice) if isinstance(node, ast.Subscript) else ():
                    if isinstance(part, ast.Name | ast.Attribute):
                        yield part.id if isinstance(part, ast.Name) else part.attr


def _compiles(decorator: ast.expr) -> bool:
    return ast.unparse(decorator).startswith("kernel")


def _module(root: Path, file: Path) -> str:
    parts = file.relative_to(root.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _imports(root: Path, trees: dict[Path, ast.Module]) -> dict[str, set[str]]:
    """Modules that each module names in its imports: packages too, those for types only and those within functions."""
    modules = {_module(root, file): tree for file, tree in trees.items()}
    found: dict[str, set[str]] = {}
    for module, tree in modules.items():
        wanted: set[str] = set()
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module:
                # of a package a name may be a module of its own
                wanted |= {inner if (inner := f"{node.module}.{name.name}") in modules else node.module for name in node.names}
            elif isinstance(node, ast.Import):
                wanted |= {name.name for name in node.names}
        found[module] = (wanted & modules.keys()) - {module}
    return found


def _circles(graph: dict[str, set[str]]) -> list[list[str]]:
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


def _across(root: Path, trees: dict[Path, ast.Module]) -> int:
    """Imports from inside another package that its packages do not declare in an `__all__`; kernels not counted."""
    faces = {_module(root, file): _declared(tree) for file, tree in trees.items() if file.name == "__init__.py"}
    count = 0
    for file, tree in trees.items():
        own = file.relative_to(root).parts[0]
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("kinetruss."):
                parts = node.module.split(".")
                public = parts[1] == "library" and len(parts) == 3 and not parts[2].startswith("_")
                declared = {name.name for name in node.names} <= faces.get(node.module, set())
                count += len(parts) > 2 and parts[1] not in (own, "kernels") and not (public or declared)
    return count


def _private(root: Path, trees: dict[Path, ast.Module]) -> int:
    """Imports of `_name`, or from a module `_name`, of another package; kernels not counted."""
    count = 0
    for file, tree in trees.items():
        own = file.relative_to(root).parts[0]
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("kinetruss."):
                parts = node.module.split(".")[1:]
                names = (*parts[1:], *(name.name for name in node.names))
                hidden = any(name.startswith("_") and not name.startswith("__") for name in names)
                count += parts[0] not in (own, "kernels") and hidden
    return count


def _exported(root: Path, trees: dict[Path, ast.Module]) -> set[str]:
    """``package.name`` of what public packages declare, and what the top level alone has; a name that both have counts once."""
    top = trees[root / "__init__.py"]
    listed = {ast.unparse(node.targets[0]): node.value for node in top.body if isinstance(node, ast.Assign)}
    public = ast.literal_eval(listed["_PACKAGES"]).split()
    homes = ast.literal_eval(listed["_NAMES"])
    found = {f"{package}.{name}" for package in public for name in _declared_by(root, trees, package)}
    return found | {f"{home}.{name}" for home, names in homes.items() for name in names.split()} | {"__version__"}


def _declared_by(root: Path, trees: dict[Path, ast.Module], package: str) -> set[str]:
    """Names in the `__all__` of a package, or of a module."""
    return _declared(trees.get(root / package / "__init__.py") or trees[root / f"{package}.py"])


def _comments(text: str) -> tuple[int, int]:
    """Comments that say something, and pragmas: what only a tool reads."""
    found = [token.string for token in tokenize.generate_tokens(io.StringIO(text).readline) if token.type == tokenize.COMMENT]
    pragmas = sum(bool(PRAGMA.match(comment)) for comment in found)
    return len(found) - pragmas, pragmas


def _share(comments: dict[Path, tuple[int, int]], texts: dict[Path, str], files: list[Path]) -> float:
    """Comments in 100 lines of some files."""
    return round(100 * sum(comments[file][0] for file in files) / sum(len(texts[file].splitlines()) for file in files), 2)


def _declared(package: ast.Module) -> set[str]:
    """Names in the `__all__` of a package that lists them as they are."""
    for node in package.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.List) and ast.unparse(node.targets[0]) == "__all__":
            return {one.value for one in node.value.elts if isinstance(one, ast.Constant) and isinstance(one.value, str)}
    return set()


if __name__ == "__main__":
    main()

"""A changed table in the YAML text of a file: what did not change keeps its lines, its comments and its order."""

from __future__ import annotations

from typing import Any

import yaml

from kinetruss.io.emitting import entry_lines, scalar_text

_LOADER: Any = getattr(yaml, "CBaseLoader", yaml.BaseLoader)


def patched(text: str, before: dict[str, Any], after: dict[str, Any]) -> str | None:
    """The text with the differences between two tables written into it; None if its form does not allow it.

    before : what the text means, or that with defaults and short forms resolved. after : what it shall mean. A value that
    is equal in both stays as it is written. The caller reads the result again: aliases, for example, are not looked at.
    """
    text = text if text.endswith("\n") else f"{text}\n"
    try:
        root = yaml.compose(text, Loader=_LOADER)
    except yaml.YAMLError:
        return None
    if not isinstance(root, yaml.MappingNode) or root.flow_style:
        return None
    patch = _Patch(text)
    return patch.text() if patch.table(root, before, after) else None


def _same(a: Any, b: Any) -> bool:
    return repr(a) == repr(b)  # 1, 1.0 and True are different texts


class _Patch:
    """Replacements of parts of a text: start, end, new part."""

    def __init__(self, given: str) -> None:
        self.given = given
        self.edits: list[tuple[int, int, str]] = []

    def text(self) -> str:
        """The text with all replacements; those at one place in the order in which they were made."""
        parts, done = [], 0
        for start, end, new in sorted(self.edits, key=lambda edit: edit[:2]):
            parts += [self.given[done:start], new]
            done = end
        return "".join([*parts, self.given[done:]])

    def value(self, node: yaml.Node, before: Any, after: Any) -> bool:
        """Write a changed value in its present form; False if it needs another form, and nothing is written then."""
        count = len(self.edits)
        if _same(before, after):
            return True
        if isinstance(node, yaml.MappingNode) and isinstance(before, dict) and isinstance(after, dict):
            fits = self.table(node, before, after)
        elif isinstance(node, yaml.SequenceNode) and isinstance(before, list) and isinstance(after, list):
            fits = len(node.value) == len(before) == len(after) and all(map(self.value, node.value, before, after))
        elif isinstance(node, yaml.ScalarNode) and node.style not in ("|", ">") and not isinstance(after, (dict, list)):
            self._replace(node.start_mark.index, node.end_mark.index, scalar_text(after))
            fits = node.end_mark.index > node.start_mark.index
        else:
            fits = False
        if not fits:
            del self.edits[count:]
        return fits

    def table(self, node: yaml.MappingNode, before: dict[str, Any], after: dict[str, Any]) -> bool:
        """Write a changed table in its present form; False if it needs another form."""
        pairs = {key.value: (key, value) for key, value in node.value}
        gone = [name for name in pairs if name in before and name not in after]
        new = [name for name in after if name not in pairs and not _same(before.get(name), after[name])]
        if renamed := _renamed(before, after, gone, new):
            old, name = renamed
            key = pairs[old][0]
            self._replace(key.start_mark.index, key.end_mark.index, scalar_text(name))
            pairs = {name if other == old else other: pair for other, pair in pairs.items()}
            before = {name if other == old else other: value for other, value in before.items()}
            gone, new = [], []
        if (node.flow_style and (gone or new)) or len(gone) == len(pairs):
            return False
        for name, (key, value) in pairs.items():
            if name in gone:
                if not self._remove(key, value):
                    return False
            elif (
                name in after
                and not _same(before.get(name), after[name])
                and not self.value(value, before.get(name), after[name])
            ):
                if node.flow_style:
                    return False
                self._rewrite(key, value, after[name])
        self._add(pairs, before, after, new)
        return True

    def _rewrite(self, key: yaml.Node, value: yaml.Node, after: Any) -> None:
        lines = "\n".join(entry_lines(key.value, after, key.start_mark.column)).lstrip()
        self._replace(key.start_mark.index, self._end(value), lines)

    def _remove(self, key: yaml.Node, value: yaml.Node) -> bool:
        start = self.given.rfind("\n", 0, key.start_mark.index) + 1
        if self.given[start : key.start_mark.index].strip():
            return False
        self._replace(start, self._line_end(value), "")
        return True

    def _add(
        self, pairs: dict[str, tuple[yaml.Node, yaml.Node]], before: dict[str, Any], after: dict[str, Any], new: list[str]
    ) -> None:
        """Insert entries behind the one that precedes them; of a table of a library model only what changed."""
        if not new:
            return
        first = next(iter(pairs.values()))[0].start_mark
        place = first.index - first.column
        for name, value in after.items():
            if name in pairs:
                place = self._line_end(pairs[name][1])
            elif name in new:
                known = before.get(name)
                if isinstance(known, dict) and isinstance(value, dict):
                    value = {key: one for key, one in value.items() if not _same(known.get(key), one)}
                self._replace(place, place, "".join(f"{line}\n" for line in entry_lines(name, value, first.column)))

    def _replace(self, start: int, end: int, new: str) -> None:
        self.edits.append((start, end, new))

    def _line_end(self, node: yaml.Node) -> int:
        return self.given.find("\n", self._end(node)) + 1 or len(self.given)

    def _end(self, node: yaml.Node) -> int:
        """Where a value ends: the parser counts comments and empty lines behind a block as its part."""
        if isinstance(node, yaml.CollectionNode) and not node.flow_style and node.value:
            last = node.value[-1]
            return self._end(last[1] if isinstance(node, yaml.MappingNode) else last)
        end: int = node.end_mark.index
        if isinstance(node, yaml.ScalarNode) and node.style in ("|", ">"):
            return len(self.given[:end].rstrip("\n"))
        return end


def _renamed(before: dict[str, Any], after: dict[str, Any], gone: list[str], new: list[str]) -> tuple[str, str] | None:
    """The one entry that only has another name."""
    if len(gone) != 1 or len(new) != 1 or len(before) != len(after):
        return None
    old, name = gone[0], new[0]
    there = list(before).index(old) == list(after).index(name) and _same(before[old], after[name])
    return (old, name) if there else None

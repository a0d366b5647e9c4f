"""A model in one line, which `repr` shows, and the fields of its records in words."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from kinetruss.display import counted
from kinetruss.errors import few

if TYPE_CHECKING:
    from kinetruss.model.the_model import Model


COUNTED = (
    ("bars", "bar", ""), ("active", "active member", ""), ("beams", "beam", ""), ("links", "link", ""),
    ("bodies", "body", "bodies"), ("hubs", "hub", ""), ("membranes", "membrane", ""), ("solids", "solid", ""),
    ("springs", "spring", ""), ("supports", "support", ""), ("loads", "load", ""), ("load_cases", "load case", ""),
    ("combinations", "combination", ""),
)  # fmt: skip
"""Tables of a model that are counted -> the words for one and for several."""
NAMED = 6
"""Largest number of drives that are named."""


def described(model: Model) -> str:
    """Dimension, number of nodes, bars and other parts, names of the drives.

    >>> import kinetruss as kt
    >>> described(kt.library.mechanisms.four_bar())
    "<Model 'Four-bar linkage': planar, 4 nodes (2 fixed), 3 bars; drive: motor>"
    """
    drives = list(model.all_drives)
    driven = f"; drive{'s' * (len(drives) > 1)}: {few(drives, NAMED)}" if drives else ""
    title = f" {model.title!r}" if model.title else ""
    return f"<Model{title}: {'planar' if model.dim == 2 else 'spatial'}, {contents(model)}{driven}>"


def contents(model: Model) -> str:
    """Number of nodes, bars and other parts.

    >>> import kinetruss as kt
    >>> contents(kt.library.mechanisms.four_bar())
    '4 nodes (2 fixed), 3 bars'
    """
    fixed = model.whole.fixed  # beams are clamped at nodes
    parts = [f"{counted(len(model.nodes), 'node')} ({sum(name in fixed for name in model.nodes)} fixed)"]
    for field, word, several in COUNTED:
        count = len(getattr(model, field))
        parts += [counted(count, word, several)] if count else []
    return ", ".join(parts)


def field_texts(record: type[Any]) -> dict[str, str]:
    """What the docstrings of a record and of those that it extends say of each field, as the schema and the reference show it.

    >>> import kinetruss as kt
    >>> field_texts(kt.Rod)["diameter"]
    'm.'
    """
    names = "|".join(record.model_fields)
    field = re.compile(rf"(?:^|(?<=[.;\n] )|(?<=\n)|(?<= ))((?:{names})(?:, (?:{names}))*) : ")
    found: dict[str, str] = {}
    said = [kind.__dict__.get("__doc__") or "" for kind in reversed(record.__mro__)]
    for block in re.split(r"\n[ \t]*\n", "\n\n".join(said)):
        parts = field.split(re.sub(r"\s*\n\s+", " ", re.sub(r"\n(?=[^\n]*? : )", "\n", block)).strip())
        for key, text in zip(parts[1::2], parts[2::2], strict=True):
            found |= dict.fromkeys(key.split(", "), text.strip())
    return found

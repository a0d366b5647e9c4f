"""``--set PATH=V1,V2,...`` and other ``NAME=VALUE`` of the command line."""

from __future__ import annotations

from collections.abc import Iterable

import click

__all__ = ["pairs", "settings"]

OPENING, CLOSING = "[{(", "]})"


def settings(texts: Iterable[str]) -> dict[str, list[str]]:
    """Path -> values of all ``--set`` options; commas within brackets, braces or quotes are part of the value.

    >>> settings(["runs.lean.trajectory.duration=3,5 s", "nodes.B.at=[0, 1 m],[0, 2 m]"])
    {'runs.lean.trajectory.duration': ['3', '5 s'], 'nodes.B.at': ['[0, 1 m]', '[0, 2 m]']}
    """
    found: dict[str, list[str]] = {}
    for text in texts:
        path, sign, values = text.partition("=")
        path = path.strip()
        if not sign or not path:
            raise click.UsageError(f"--set {text!r} has no value. Write --set PATH=V1,V2, e.g. --set safety.yielding=1.5,2.")
        if path in found:
            raise click.UsageError(f"--set {path} is given twice. Give all its values at once: --set {path}=V1,V2.")
        found[path] = _split(values)
        if not all(found[path]):
            raise click.UsageError(f"--set {text!r} has an empty value. Write ~ for none.")
    return found


def pairs(option: str, texts: Iterable[str]) -> dict[str, str]:
    """Name -> value of an option that may be given several times.

    >>> pairs("--tolerance", ["M*.length=0.1 mm", "temperature = 20"])
    {'M*.length': '0.1 mm', 'temperature': '20'}
    """
    found: dict[str, str] = {}
    for text in texts:
        name, _, value = (part.strip() for part in text.partition("="))
        if not name or not value:
            raise click.UsageError(f"{option} {text!r} has no name or no value. Write {option} NAME=VALUE.")
        if name in found:
            raise click.UsageError(f"{option} {name} is given twice. Give one value.")
        found[name] = value
    return found


def _split(text: str) -> list[str]:
    depth, quote, parts = 0, "", [""]
    for sign in text:
        if quote:
            quote = "" if sign == quote else quote
        elif sign in "\"'":
            quote = sign
        else:
            depth += (sign in OPENING) - (sign in CLOSING)
        if sign == "," and not quote and depth <= 0:
            parts.append("")
        else:
            parts[-1] += sign
    return [part.strip() for part in parts]

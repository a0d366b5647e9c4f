"""HTML from plain data: all text that is not `Markup` is escaped."""

from __future__ import annotations

import html
from collections.abc import Iterable
from typing import Any

POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:"
"""Content security policy of pages: the browser sends no request."""
VOID = ("br", "img", "link", "meta")


class Markup(str):
    """A text that is already HTML."""

    __slots__ = ()

    def __html__(self) -> str:
        """The text, for templates."""
        return self


def element(name: str, *content: Any, **attributes: Any) -> Markup:
    """One element. Attributes: ``class_="x"``, ``data_name="y"``; None and False omit one, True gives it without a value.

    >>> element("p", "a < b ", element("b", "c"), class_="note")
    '<p class="note">a &lt; b <b>c</b></p>'
    """
    words = "".join(_attribute(key, value) for key, value in attributes.items() if value is not None and value is not False)
    return Markup(f"<{name}{words}>" if name in VOID else f"<{name}{words}>{joined(content)}</{name}>")


def _attribute(key: str, value: Any) -> str:
    name = key.rstrip("_").replace("_", "-")
    return f" {name}" if value is True else f' {name}="{html.escape(str(value))}"'


def joined(content: Any) -> Markup:
    """Texts, elements and lists of them, joined in order; None is empty."""
    if content is None:
        return Markup("")
    if isinstance(content, Markup):
        return content
    if isinstance(content, Iterable) and not isinstance(content, str):
        return Markup("".join(joined(one) for one in content))
    return Markup(html.escape(str(content)))


def html_page(title: str, head: str, body: str, policy: str = POLICY) -> str:
    """A whole page. head, body : HTML of the body, and of the head in addition to what every page has."""
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<link rel="icon" href="data:,">
<title>{html.escape(title)}</title>
{head}</head>
<body>
{body}
</body>
</html>
"""

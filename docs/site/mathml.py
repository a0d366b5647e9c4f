"""Formulas as MathML: browsers show them without a script and without a network.

Brackets around a matrix are drawn by the style sheet. As characters they grow only with a mathematical font.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from docutils.nodes import SkipNode
from latex2mathml.converter import convert

if TYPE_CHECKING:
    from docutils.nodes import Element
    from sphinx.application import Sphinx

__all__ = ["formula", "setup"]

BRACKETED = re.compile(r"<mo>&#x00028;</mo><mtable>((?:(?!<mtable).)*?)</mtable><mo>&#x00029;</mo>")
"""A matrix in parentheses, without another matrix inside."""


def formula(text: str, display: str) -> str:
    """MathML of a formula of LaTeX; display : inline or block."""
    found = convert(text, display=display)
    found = found.replace('width="negativethinmathspace"', 'width="-0.167em"')  # names of widths are no longer read
    return BRACKETED.sub(r'<mrow class="bracketed"><mtable>\1</mtable></mrow>', found)


def _inline(translator: Any, node: Element) -> None:
    translator.body.append(formula(node.astext(), "inline"))
    raise SkipNode


def _displayed(translator: Any, node: Element) -> None:
    translator.body.append(f'<div class="math">{formula(node.astext(), "block")}</div>\n')
    raise SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    """Sphinx calls this."""
    app.add_html_math_renderer("mathml", (_inline, None), (_displayed, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}

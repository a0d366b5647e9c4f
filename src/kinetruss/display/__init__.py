"""What people read, said once: numbers with units, colours, tables, the frame of a page. No physics, no results."""

from kinetruss.display.html import POLICY, Markup, element, html_page, joined
from kinetruss.display.numbers import instant, number, quantity, scale
from kinetruss.display.tables import Table

__all__ = ["POLICY", "Markup", "Table", "html_page", "element", "instant", "joined", "number", "quantity", "scale"]

"""Reports, tables and figures of results. This package computes no physics. Parts are imported when first used."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.report._page import Page
    from kinetruss.report.along.diagrams import diagrams, diagrams_page
    from kinetruss.report.document._document import document_page
    from kinetruss.report.document._lines import lines
    from kinetruss.report.document._sizing import read_sizing, sizing_page
    from kinetruss.report.document._write import write_document, write_page
    from kinetruss.report.pictures.figures import figures
    from kinetruss.report.pictures.histories import histories_svg
    from kinetruss.report.pictures.maps import map_picture
    from kinetruss.report.pictures.picture import picture
    from kinetruss.report.pictures.plot import plot
    from kinetruss.report.pictures.quantities import curves
    from kinetruss.report.run_text.summary import summary
    from kinetruss.report.text.beside import beside
    from kinetruss.report.text.compare import compare
    from kinetruss.report.text.explain import explain
    from kinetruss.report.text.gauges import gauges, gauges_picture
    from kinetruss.report.text.joints import joints
    from kinetruss.report.text.variants import variants

__all__ = [
    "Page", "beside", "compare", "curves", "diagrams", "diagrams_page", "document_page", "explain", "figures", "gauges",
    "gauges_picture", "histories_svg", "joints", "lines",
    "map_picture", "picture", "plot", "read_sizing", "sizing_page", "summary", "variants", "write_document", "write_page",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "_page": "Page",
        "along.diagrams": "diagrams diagrams_page",
        "document._document": "document_page",
        "document._lines": "lines",
        "document._sizing": "read_sizing sizing_page",
        "document._write": "write_document write_page",
        "pictures.figures": "figures",
        "pictures.histories": "histories_svg",
        "pictures.maps": "map_picture",
        "pictures.picture": "picture",
        "pictures.plot": "plot",
        "pictures.quantities": "curves",
        "text.beside": "beside",
        "text.compare": "compare",
        "text.explain": "explain",
        "text.gauges": "gauges gauges_picture",
        "text.joints": "joints",
        "run_text.summary": "summary",
        "text.variants": "variants",
    },
)

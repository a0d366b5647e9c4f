"""Reports, tables and figures of results. This package computes no physics. Parts are imported when first used."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.report.comparisons import beside as beside, compare as compare
    from kinetruss.report.document.diagram_pages import diagrams as diagrams, diagrams_page as diagrams_page
    from kinetruss.report.document.optimum_report import optimum_page as optimum_page
    from kinetruss.report.document.run_report import document_page as document_page, lines as lines
    from kinetruss.report.document.sizing_report import read_sizing as read_sizing, sizing_page as sizing_page
    from kinetruss.report.document.writing import write_document as write_document, write_page as write_page
    from kinetruss.report.explanations import explain as explain
    from kinetruss.report.mechanism import motion as motion
    from kinetruss.report.page import Page as Page
    from kinetruss.report.pictures.picture import picture as picture
    from kinetruss.report.pictures.quantities import curves as curves
    from kinetruss.report.plots import (
        histories_svg as histories_svg,
        map_picture as map_picture,
        plot as plot,
        plot_node as plot_node,
    )
    from kinetruss.report.readings import gauges as gauges, gauges_picture as gauges_picture, joints as joints
    from kinetruss.report.run_figures import figures as figures
    from kinetruss.report.run_summary import summary as summary
    from kinetruss.report.study_page import study as study, study_figures as study_figures
    from kinetruss.report.variant_table import variants as variants

__getattr__, __dir__, __all__ = late(__name__)

"""What people read: tables, figures. Reads results and computes no physics. Parts are imported when first used."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late
from kinetruss.results.store import PICTURES, REPORT

if TYPE_CHECKING:
    from kinetruss.report.document._document import document_page
    from kinetruss.report.document._record import document_record
    from kinetruss.report.document._write import Written, write_document
    from kinetruss.report.pictures.figures import figures
    from kinetruss.report.pictures.painters import painters
    from kinetruss.report.pictures.picture import picture
    from kinetruss.report.pictures.plot import plot
    from kinetruss.report.pictures.quantities import Curve, curves
    from kinetruss.report.text.compare import Maximum, compare, compare_csv, compare_records, compare_text
    from kinetruss.report.text.explain import (
        free_body_record,
        free_body_rows,
        free_body_text,
        system_record,
        system_rows,
        system_text,
        write_rows,
    )
    from kinetruss.report.text.gauges import gauges_picture, gauges_record, gauges_rows, gauges_text
    from kinetruss.report.text.joints import JointForces, joints, joints_record, joints_text
    from kinetruss.report.text.summary import summary, summary_text
    from kinetruss.report.text.variants import variant_records, variants_text

__all__ = [
    "compare", "compare_csv", "compare_records", "compare_text", "Curve", "curves", "document_page", "document_record",
    "figures", "free_body_record", "free_body_rows", "free_body_text", "gauges_picture", "gauges_record", "gauges_rows",
    "gauges_text", "JointForces", "joints", "joints_record", "joints_text", "Maximum", "painters", "picture",
    "PICTURES", "plot", "REPORT", "summary", "summary_text", "system_record", "system_rows", "system_text",
    "variant_records", "variants_text", "write_document", "write_rows", "Written",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "document._document": "document_page",
        "document._record": "document_record",
        "document._write": "Written write_document",
        "pictures.figures": "figures",
        "pictures.painters": "painters",
        "pictures.picture": "picture",
        "pictures.plot": "plot",
        "pictures.quantities": "Curve curves",
        "text.compare": "Maximum compare compare_csv compare_records compare_text",
        "text.explain": "free_body_record free_body_rows free_body_text system_record system_rows system_text write_rows",
        "text.gauges": "gauges_picture gauges_record gauges_rows gauges_text",
        "text.joints": "JointForces joints joints_record joints_text",
        "text.summary": "summary summary_text",
        "text.variants": "variant_records variants_text",
    },
)

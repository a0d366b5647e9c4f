"""What people read: tables, figures. Reads results and computes no physics. Parts are imported when first used."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from kinetruss.results.store.folder import PICTURES, REPORT

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
    from kinetruss.report.text.tables import number, quantity, table
    from kinetruss.report.text.variants import variant_records, variants_text

__all__ = [
    "compare", "compare_csv", "compare_records", "compare_text", "Curve", "curves", "document_page", "document_record",
    "figures", "free_body_record", "free_body_rows", "free_body_text", "gauges_picture", "gauges_record", "gauges_rows",
    "gauges_text", "JointForces", "joints", "joints_record", "joints_text", "Maximum", "number", "painters", "picture",
    "PICTURES", "plot", "quantity", "REPORT", "summary", "summary_text", "system_record", "system_rows", "system_text", "table",
    "variant_records", "variants_text", "write_document", "write_rows", "Written",
]  # fmt: skip

_HOME = {
    "Written": "document._write", "document_page": "document._document", "document_record": "document._record",
    "write_document": "document._write",
    "Curve": "pictures.quantities", "curves": "pictures.quantities",
    "Maximum": "text.compare", "compare": "text.compare", "compare_csv": "text.compare", "compare_records": "text.compare",
    "compare_text": "text.compare", "variant_records": "text.variants", "variants_text": "text.variants",
    "gauges_picture": "text.gauges", "gauges_record": "text.gauges", "gauges_rows": "text.gauges", "gauges_text": "text.gauges",
    "free_body_record": "text.explain", "free_body_rows": "text.explain", "free_body_text": "text.explain", "system_record": "text.explain",
    "system_rows": "text.explain", "system_text": "text.explain", "write_rows": "text.explain",
    "JointForces": "text.joints", "figures": "pictures.figures", "joints": "text.joints", "joints_record": "text.joints",
    "joints_text": "text.joints", "number": "text.tables", "painters": "pictures.painters", "picture": "pictures.picture", "plot": "pictures.plot",
    "quantity": "text.tables", "summary": "text.summary", "summary_text": "text.summary", "table": "text.tables",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.report.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.report' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__

"""What people read: tables, figures. Reads results and computes no physics. Parts are imported when first used."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from kinetruss.results._folder import PICTURES, REPORT

if TYPE_CHECKING:
    from kinetruss.report._compare import Maximum, compare, compare_csv, compare_records, compare_text
    from kinetruss.report._explain import (
        free_body_record,
        free_body_rows,
        free_body_text,
        system_record,
        system_rows,
        system_text,
        write_rows,
    )
    from kinetruss.report._figures import figures
    from kinetruss.report._gauges import gauges_picture, gauges_record, gauges_rows, gauges_text
    from kinetruss.report._joints import JointForces, joints, joints_record, joints_text
    from kinetruss.report._painters import painters
    from kinetruss.report._picture import picture
    from kinetruss.report._plot import plot
    from kinetruss.report._quantities import Curve, curves
    from kinetruss.report._summary import summary, summary_text
    from kinetruss.report._text import number, quantity, table
    from kinetruss.report._variants import variant_records, variants_text
    from kinetruss.report.document._document import document_page
    from kinetruss.report.document._record import document_record
    from kinetruss.report.document._write import Written, write_document

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
    "Curve": "_quantities", "curves": "_quantities",
    "Maximum": "_compare", "compare": "_compare", "compare_csv": "_compare", "compare_records": "_compare",
    "compare_text": "_compare", "variant_records": "_variants", "variants_text": "_variants",
    "gauges_picture": "_gauges", "gauges_record": "_gauges", "gauges_rows": "_gauges", "gauges_text": "_gauges",
    "free_body_record": "_explain", "free_body_rows": "_explain", "free_body_text": "_explain", "system_record": "_explain",
    "system_rows": "_explain", "system_text": "_explain", "write_rows": "_explain",
    "JointForces": "_joints", "figures": "_figures", "joints": "_joints", "joints_record": "_joints",
    "joints_text": "_joints", "number": "_text", "painters": "_painters", "picture": "_picture", "plot": "_plot",
    "quantity": "_text", "summary": "_summary", "summary_text": "_summary", "table": "_text",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(importlib.import_module(f"kinetruss.report.{_HOME[name]}"), name)
    raise AttributeError(f"module 'kinetruss.report' has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__

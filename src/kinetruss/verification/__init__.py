"""The field's verification manual, always run: published and exact references against what the product computes."""

from kinetruss.verification._case import Entry, Report
from kinetruss.verification._verify import verify

__all__ = ["Entry", "Report", "verify"]

"""The field's verification manual, always run: published and exact references against what the product computes.

Every entry has a class, a key of `CLAIMS`, that says what its agreement shows.
"""

from kinetruss.verification._case import Entry, Report
from kinetruss.verification._reference import CLAIMS
from kinetruss.verification._verify import verify

__all__ = ["CLAIMS", "Entry", "Report", "verify"]

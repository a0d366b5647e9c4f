"""The verification suite: compares results of kinetruss with published and exact references.

Every entry has a class, a key of `CLAIMS`, which says what its agreement shows.
"""

from kinetruss.late import listed
from kinetruss.verification._case import Entry, Report
from kinetruss.verification._reference import CLAIMS
from kinetruss.verification._verify import verify

__all__ = ["CLAIMS", "Entry", "Report", "verify"]

__dir__ = listed(__name__)

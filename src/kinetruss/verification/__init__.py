"""The verification suite: compares results of kinetruss with published and exact references.

Every entry has a class, a key of `CLAIMS`, which says what its agreement shows.
"""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.verification.cases import CLAIMS as CLAIMS, Entry as Entry, Report as Report, verify as verify

__getattr__, __dir__, __all__ = late(__name__)

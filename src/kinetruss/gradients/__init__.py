"""Exact gradients of results by the numbers of a model. Parts are imported when first used."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.gradients.derivatives import (
        Check as Check,
        Response as Response,
        check_gradient as check_gradient,
        gradient as gradient,
        value_and_gradient as value_and_gradient,
    )
    from kinetruss.gradients.responses import (
        Entries as Entries,
        Read as Read,
        read_entries as read_entries,
        read_response as read_response,
    )

__getattr__, __dir__, __all__ = late(__name__)

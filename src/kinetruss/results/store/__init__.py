"""The run store: folders with one writer each that are readable during the run and after an interruption."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.results.store.folder import (
        PICTURES,
        REPORT,
        Ledger,
        check_target,
        claimed,
        clear,
        is_locked,
        is_store,
        read_ledger,
    )
    from kinetruss.results.store.lock import check_unlocked, holding
    from kinetruss.results.store.packed import pack
    from kinetruss.results.store.store import Store, Writer, create, key, open_store, reopen
    from kinetruss.results.store.whole import whole_file

__all__ = [
    "Ledger", "PICTURES", "REPORT", "Store", "Writer", "check_target", "check_unlocked", "claimed", "clear", "create",
    "holding", "is_locked", "is_store", "key", "open_store", "pack", "read_ledger", "reopen", "whole_file",
]  # fmt: skip

__getattr__, __dir__ = late(
    __name__,
    {
        "folder": "Ledger PICTURES REPORT check_target claimed clear is_locked is_store read_ledger",
        "lock": "check_unlocked holding",
        "packed": "pack",
        "store": "Store Writer create key open_store reopen",
        "whole": "whole_file",
    },
)

"""Messages of pages: JSON that must be one of some small records; what a page is told while its answer takes long."""

from __future__ import annotations

import json
import time
from typing import Any

from pydantic import BaseModel, ConfigDict, TypeAdapter, ValidationError

from kinetruss.errors import InputError
from kinetruss.kernels.compiled.jit import keeper

LATELY = 1.0
"""Seconds after a kernel within which the next one is expected."""


class Busy:
    """What is done since it was made, in words."""

    def __init__(self) -> None:
        self.began, self.before, self.spent = time.monotonic(), keeper.progress.count, keeper.progress.seconds

    def compiling(self) -> str:
        """How much was compiled; empty where nothing is compiled now."""
        found = keeper.progress
        if not found.at_work and (found.changed < self.began or found.clock() - found.changed > LATELY):
            return ""
        count, seconds = found.count - self.before, found.seconds - self.spent
        return f"Compiling (first start only): {count} kernel{'' if count == 1 else 's'}, {seconds:.0f} s"

    def text(self) -> str:
        """What is done, and for how long."""
        seconds = int(time.monotonic() - self.began)
        return self.compiling() or (f"Computing: {seconds} s" if seconds else "Computing ...")


# Messages of pages: JSON that must be one of some small records.


class Message(BaseModel):
    """The base of all commands of pages."""

    model_config = ConfigDict(extra="forbid", frozen=True)


def read_message(text: str | bytes, commands: TypeAdapter[Any], most: int) -> Any:
    """The command in a message of at most `most` bytes.

    Raises
    ------
    InputError : too long, not JSON, or not a known command.
    """
    if len(text) > most:
        raise InputError(f"A message of {len(text)} bytes is refused. Send at most {most}.")
    try:
        return commands.validate_python(json.loads(text))
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        where = ".".join(str(part) for part in first["loc"])
        raise InputError(f"This message is not understood. {where or 'message'}: {first['msg']}.") from None
    except (ValueError, RecursionError):
        raise InputError("This message is not JSON.") from None

"""Messages of pages: JSON that must be one of some small records."""

from __future__ import annotations

import json
from typing import Any

from pydantic import BaseModel, ConfigDict, TypeAdapter, ValidationError

from kinetruss.errors import InputError

__all__ = ["Message", "read_message"]


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

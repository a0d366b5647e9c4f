"""What a page may send: functions of a session as messages, and the message in a text."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from pydantic import BaseModel, ConfigDict, ValidationError, create_model

from kinetruss.errors import InputError
from kinetruss.model import nearest

if TYPE_CHECKING:
    from kinetruss.studio.session import Answer

Act = Callable[..., "Answer"]
MESSAGES: dict[str, tuple[type[BaseModel], Act]] = {}
"""Name -> the record of its arguments, and what does it."""


def message(act: Act) -> Act:
    """A function of a session as a message of its name; its other arguments are checked as they are annotated."""
    _, *given = inspect.signature(act).parameters.values()
    fields: dict[str, Any] = {one.name: (one.annotation, ... if one.default is one.empty else one.default) for one in given}
    name = act.__name__.rstrip("_")
    record = create_model(name, __config__=ConfigDict(extra="forbid"), __module__=act.__module__, **fields)
    MESSAGES[name] = record, act
    return act


def message_of(text: str | bytes, most: int) -> tuple[str, Act]:
    """The message in a text of at most `most` bytes: its name, and what it does with a session.

    Raises
    ------
    InputError : too long, not JSON, or not a known message.
    """
    if len(text) > most:
        raise InputError(f"A message of {len(text)} bytes is refused. Send at most {most}.")
    try:
        given = json.loads(text)
    except (ValueError, RecursionError):
        raise InputError("This message is not JSON.") from None
    name = given.pop("do", None) if isinstance(given, dict) else None
    if not isinstance(name, str) or name not in MESSAGES:
        raise InputError(f"This message is not understood. do: {nearest(str(name)[:100], MESSAGES)}")
    record, act = MESSAGES[name]
    try:
        found = record.model_validate(given)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        where = ".".join([name, *(str(part) for part in first["loc"])])
        raise InputError(f"This message is not understood. {where}: {first['msg']}.") from None
    return name, partial(act, **{one: getattr(found, one) for one in record.model_fields})

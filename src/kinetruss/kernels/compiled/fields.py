"""Fields of records in kernels: their types, and the code that reads and sets them."""

from __future__ import annotations

from typing import Any

from numba import types
from numba.core.typing.templates import AttributeTemplate
from numba.cpython.tupleobj import namedtuple_getattr
from numba.extending import infer_getattr as _infer_getattr, lower_getattr as _lower_getattr, lower_setattr as _lower_setattr

from kinetruss.kernels.compiled.record import Field, on_declaration
from kinetruss.kernels.compiled.views import array_on

__all__: list[str] = []

infer_getattr: Any = _infer_getattr
lower_getattr: Any = _lower_getattr
lower_setattr: Any = _lower_setattr


def _field_of(pair: Any, name: str) -> Field | None:
    """The field of a tuple's type, where it is a record that has one of this name."""
    found: Field | None = getattr(getattr(pair, "instance_class", None), "FIELDS", {}).get(name)
    return found


def _typed(pair: Any, field: Field) -> Any:
    """The type of a field in kernels."""
    kind = pair.types[field.buffer].dtype
    return types.Array(kind, field.axes, "C") if field.axes else kind


def _found(context: Any, builder: Any, pair: Any, value: Any, field: Field) -> tuple[Any, list[Any]]:
    """Where a field begins, and its shape."""
    ints, kept = (
        context.make_array(pair.types[k])(context, builder, builder.extract_value(value, k)) for k in (0, field.buffer)
    )
    if not field.axes:
        return builder.gep(kept.data, [context.get_constant(types.intp, field.place)]), []
    at = [context.get_constant(types.intp, 3 * field.place + k) for k in range(1 + field.axes)]
    offset, *shape = (builder.load(builder.gep(ints.data, [place])) for place in at)
    return builder.gep(kept.data, [offset]), shape


@infer_getattr
class _Fields(AttributeTemplate):
    """Types of fields in kernels."""

    key = types.BaseNamedTuple

    def generic_resolve(self, pair: Any, name: str) -> Any:  # type: ignore[override]
        field = _field_of(pair, name)
        return None if field is None else _typed(pair, field)


def _lower(name: str) -> None:
    """Code of the fields of a name, whatever record they are of."""

    @lower_getattr(types.BaseNamedTuple, name)
    def read(context: Any, builder: Any, pair: Any, value: Any) -> Any:
        field = _field_of(pair, name)
        if field is None:  # a plain named tuple
            return namedtuple_getattr(context, builder, pair, value, name)
        data, shape = _found(context, builder, pair, value, field)
        return array_on(context, builder, _typed(pair, field), data, shape) if field.axes else builder.load(data)

    @lower_setattr(types.BaseNamedTuple, name)
    def write(context: Any, builder: Any, signature: Any, args: Any) -> None:
        pair, kind = signature.args
        field = _field_of(pair, name)
        if field is None or field.axes:
            raise TypeError(f"{name} is no number of a record, and cannot be set.")
        data, _ = _found(context, builder, pair, args[0], field)
        builder.store(context.cast(builder, args[1], kind, pair.types[field.buffer].dtype), data)


on_declaration(_lower)

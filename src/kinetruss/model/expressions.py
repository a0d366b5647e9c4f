"""Expressions of node positions as text: what may stand in them, as a tree; what a tree measures, and in which unit.

They are read by Python's own grammar (`ast`), of which a short list of constructs is taken and nothing is executed: numbers,
names, + - * / and powers, components of vectors, and the functions of `FUNCTIONS`.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

from kinetruss.errors import shown
from kinetruss.model.expression_kinds import (
    ANGLE,
    AXES,
    CONSTANTS,
    FORCE_UNITS,
    FUNCTIONS,
    LENGTH,
    NUMBER,
    PLACE,
    Kind,
    function_of,
    in_unit,
    same_unit,
)
from kinetruss.model.measured_forces import FUNCTIONS as OF_RESULTS, OF_SUPPORTS, ExpressionError, variable_of
from kinetruss.model.words import nearest

if TYPE_CHECKING:
    from collections.abc import Iterator

    from kinetruss.model.data import ModelData

LONGEST = 1000
"""Characters of an expression."""
DEEPEST = 60
"""Levels of brackets and operations in each other."""
LARGEST_POWER = 8


class Tree(NamedTuple):
    """What an expression computes. op : ``number`` (value), ``name`` (value), ``add`` ``subtract`` ``multiply`` ``divide``
    ``power`` (value: the exponent) ``negate``, ``part`` (value: 0, 1 or 2), a function of `FUNCTIONS`, a kind of `KINDS`
    (value: the name), ``rate``, ``named`` (value: the function, the table or None, the name),
    ``result`` (value: a `Variable`). text : as it is written.
    """

    op: str
    parts: tuple[Tree, ...] = ()
    value: Any = None
    text: str = ""


KINDS = ("node", "member", "drive", "quantity")
"""What a name may stand for; each is also a function, for a name that several have."""
# Reading.

_OPERATIONS: dict[type, str] = {ast.Add: "add", ast.Sub: "subtract", ast.Mult: "multiply", ast.Div: "divide"}


def read_expression(text: str) -> Tree:
    """The tree of an expression; names are not yet looked up.

    Raises
    ------
    ExpressionError : it is no expression, or has what may not stand in one.

    >>> read_expression("P.y - 20*mm").op
    'subtract'
    """
    if len(text) > LONGEST:
        raise ExpressionError(f"has {len(text)} characters, more than {LONGEST}.", "Divide it into several quantities.")
    try:
        found = ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        why = error.msg if isinstance(error, SyntaxError) and error.msg else "it cannot be read"
        raise ExpressionError(
            f"{shown(text)} is no expression: {why}.", "Write for example distance(A, B), or angle(crank)."
        ) from None
    return _tree(found, text.strip(), 0)


def _tree(node: Any, text: str, depth: int) -> Tree:
    if depth > DEEPEST:
        raise ExpressionError(f"has more than {DEEPEST} operations in each other.", "Divide it into several quantities.")

    def below(*ones: Any) -> tuple[Tree, ...]:
        return tuple(_tree(one, text, depth + 1) for one in ones)

    own = ast.get_source_segment(text, node) or text
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool):
        return Tree("number", value=_finite(node.value, own), text=own)
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return Tree("name", value=node.value, text=own)
    if isinstance(node, ast.Name):
        return Tree("name", value=node.id, text=own)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return Tree("negate", below(node.operand), text=own)
    if isinstance(node, ast.BinOp) and type(node.op) in _OPERATIONS:
        return Tree(_OPERATIONS[type(node.op)], below(node.left, node.right), text=own)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        return Tree("power", below(node.left), value=_exponent(node.right, own), text=own)
    if isinstance(node, ast.Attribute):
        if node.attr not in ("x", "y", "z"):
            raise ExpressionError(
                f"has no part {node.attr!r} in {own!r}.", 'Write .x, .y or .z; a name with a dot as text: node("A.1").'
            )
        return Tree("part", below(node.value), value="xyz".index(node.attr), text=own)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
        return _call(node, own, below)
    raise ExpressionError(
        f"has {own!r}, which may not stand here.", f"Write numbers, names, + - * / **, and {', '.join(FUNCTIONS)}, rate."
    )


def _call(node: ast.Call, own: str, below: Callable[..., tuple[Tree, ...]]) -> Tree:
    """A function with its arguments."""
    name = node.func.id  # type: ignore[attr-defined]
    if name in KINDS:
        named = _named(node.args[0]) if len(node.args) == 1 else None
        if named is None:
            raise ExpressionError(f"{own!r} names no {name}.", f"Write for example {name}(A).")
        return Tree(name, value=named, text=own)
    if name in OF_RESULTS:
        return _of_result(name, node, own, below)
    if name not in FUNCTIONS and name != "rate":
        raise ExpressionError(f"has no function {name!r}.", nearest(name, [*FUNCTIONS, "rate", *OF_RESULTS, *KINDS]))
    if name == "rate" and len(node.args) != 1:
        raise ExpressionError(
            f"rate(...) takes one expression; it has {len(node.args)}.", "Write for example rate(angle(crank))."
        )
    return Tree(name, below(*node.args), text=own)


def _named(node: Any) -> str | None:
    """The name that stands for itself or in quotes; None for anything else."""
    found = node.id if isinstance(node, ast.Name) else node.value if isinstance(node, ast.Constant) else None
    return found if isinstance(found, str) else None


def _of_result(name: str, node: ast.Call, own: str, below: Callable[..., tuple[Tree, ...]]) -> Tree:
    """A force of a part: ``force(A)``, ``force(drive(A))``; of a support its component too: ``reaction(A, ex)``."""
    one = node.args[0] if node.args else None
    table = None
    if isinstance(one, ast.Call) and isinstance(one.func, ast.Name) and len(one.args) == 1 and not one.keywords:
        table, one = one.func.id, one.args[0]
    if (part := _named(one)) is None or len(node.args) > (2 if name in OF_SUPPORTS else 1):
        raise ExpressionError(f"{own!r} names no part.", f"Write for example {OF_RESULTS[name]}.")
    found = Tree("named", value=(name, table, part), text=own)
    return Tree("dot", (found, *below(node.args[1])), text=own) if len(node.args) == 2 else found


def _finite(value: float, own: str) -> float:
    if isinstance(value, int) and abs(value) > 10**15:
        value = math.inf
    if not math.isfinite(value):
        raise ExpressionError(f"has the number {shown(own)}, which is too large.", "Give a smaller one.")
    return float(value)


def _exponent(node: Any, own: str) -> Fraction:
    sign = 1
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        sign, node = -1, node.operand
    value: Any = node.value if isinstance(node, ast.Constant) else None
    if type(value) in (int, float) and abs(value) <= LARGEST_POWER and float(2 * value).is_integer():
        return Fraction(sign * int(2 * value), 2)
    raise ExpressionError(
        f"has the power {own!r}.", f"Exponents are whole or half numbers up to {LARGEST_POWER}: a**2, a**0.5."
    )


# Names and units.


def looked_up(model: ModelData, tree: Tree) -> Tree:
    """The tree with every name replaced by what it stands for in a model: a node, a member, a drive, a quantity, a constant.

    Raises
    ------
    ExpressionError : unknown names, and those that stand for several things.
    """
    if tree.op in KINDS:
        if tree.value not in (known := _known(model)[tree.op]):
            raise ExpressionError(f"has no {tree.op} called {tree.value!r}.", nearest(tree.value, known))
        return tree
    if tree.op == "named":
        function, table, part = tree.value
        read = Tree("result", value=variable_of(model, function, table, part), text=tree.text)
        if function != "power" or read.value.axis != "drive":
            return read
        return Tree("multiply", (read, Tree("rate", (Tree("drive", value=part),))), text=tree.text)
    if tree.op != "name":
        return tree._replace(parts=tuple(looked_up(model, one) for one in tree.parts))
    known, name = _known(model), tree.value
    found = [kind for kind, names in known.items() if name in names]
    if found == ["member", "drive"] and name not in model.drives:
        found = ["member"]  # the drive of a member, of its own name
    quoted = name if name.isidentifier() else f'"{name}"'
    if len(found) > 1 or (found and name in (*CONSTANTS, *AXES)):
        kinds = [*found, *(["unit" if name in CONSTANTS else "axis"] if name in (*CONSTANTS, *AXES) else [])]
        mend = f"Write {' or '.join(f'{kind}({quoted})' for kind in found)}."
        raise ExpressionError(f"{name!r} is a {' and a '.join(kinds)}.", mend)
    if found:
        return Tree(found[0], value=name, text=tree.text)
    if name in AXES:
        return Tree("axis", value=name, text=tree.text)
    if name in CONSTANTS:
        return Tree("constant", value=name, text=tree.text)
    if name in FORCE_UNITS:
        return Tree("constant", value=name, text=tree.text)
    every = [one for names in known.values() for one in names]
    raise ExpressionError(f"has no node, member, drive or quantity called {name!r}.", nearest(name, every))


def _known(model: ModelData) -> dict[str, Any]:
    return {
        "node": {name: None for name, one in model.nodes.items() if not one.scalar},
        "member": {**model.members, **model.bending},
        "drive": model.all_drives,
        "quantity": model.quantities,
    }


def kind_of(model: ModelData, tree: Tree, inside: tuple[str, ...] = ()) -> Kind:
    """What a tree measures, names looked up. inside : the quantities of which this one is a part.

    Raises
    ------
    ExpressionError : units that do not match, wrong arguments, a quantity that needs itself.
    """
    if tree.op == "number":
        return NUMBER
    if tree.op == "constant":
        return {**CONSTANTS, **FORCE_UNITS}[tree.value][1]
    if tree.op == "result":
        return in_unit(tree.value.unit, tree.value.vector)
    if tree.op == "axis":
        return Kind(vector=True)
    if tree.op in ("node", "member"):
        return PLACE
    if tree.op == "drive":
        return ANGLE if model.all_drives[tree.value].kind in ("angle", "hinge") else LENGTH
    if tree.op == "quantity":
        return _of_quantity(model, tree.value, inside)
    given = [kind_of(model, one, inside) for one in tree.parts]
    if tree.op == "rate" and (one := next(forces_in(model, tree.parts[0]), None)) is not None:
        raise ExpressionError(
            f"{tree.text!r} is the rate of {one.text!r}, which has none.", "Take rates of places, lengths and angles only."
        )
    if tree.op in FUNCTIONS:
        try:
            return function_of(tree.op, given, model.dim).kind(given)
        except ExpressionError as error:
            raise ExpressionError(
                error.message if tree.op in error.message else f"{tree.text!r} {error.message}", error.mend
            ) from None
    return _of_operation(tree, given)


def _of_quantity(model: ModelData, name: str, inside: tuple[str, ...]) -> Kind:
    if name in inside:
        raise ExpressionError(f"needs itself: {' of '.join((*inside[inside.index(name) :], name))}.", "Take one of them out.")
    if len(inside) > DEEPEST:
        raise ExpressionError(f"rests on more than {DEEPEST} quantities, each on the next.", "Write some of them directly.")
    return kind_of(model, looked_up(model, model.quantities[name].tree), (*inside, name))


def _of_operation(tree: Tree, given: Sequence[Kind]) -> Kind:
    first, last = given[0], given[-1]
    if tree.op == "part":
        if not first.vector:
            raise ExpressionError(
                f"{tree.text!r} takes a part of a number.", "A node, a member, a difference of places have parts."
            )
        return first._replace(vector=False)
    if tree.op == "rate":
        return first._replace(time=first.time - 1)
    if tree.op == "negate":
        return first
    if tree.op == "power":
        if first.vector:
            raise ExpressionError(f"{tree.text!r} is a power of a vector.", "Take its length first.")
        return first.to(tree.value)
    vectors = [one.vector for one in given]
    if tree.op in ("add", "subtract"):
        if vectors[0] != vectors[1]:
            raise ExpressionError(
                f"{tree.text!r} puts a vector and a number together.", "Take a component, as A.x, or a length."
            )
        try:
            same_unit(first, last)
        except ExpressionError as error:
            raise ExpressionError(f"{tree.text!r} {error.message}", error.mend) from None
        return first if first.turn >= last.turn else last
    if (tree.op == "multiply" and all(vectors)) or (tree.op == "divide" and vectors[1]):
        raise ExpressionError(f"{tree.text!r} multiplies or divides by a vector.", "Write dot(a, b) or cross(a, b).")
    return first.times(last, 1 if tree.op == "multiply" else -1)


def walk(tree: Tree) -> Iterator[Tree]:
    """A tree and all that are in it."""
    yield tree
    for one in tree.parts:
        yield from walk(one)


def forces_in(model: ModelData, tree: Tree) -> Iterator[Tree]:
    """What a tree reads from forces, also in the quantities that it names; names looked up."""
    for one in walk(tree):
        if one.op == "result":
            yield one
        elif one.op == "quantity":
            yield from forces_in(model, looked_up(model, model.quantities[one.value].tree))

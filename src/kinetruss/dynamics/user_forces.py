"""Forces from a function of the user: compiled, or plain Python whose exceptions are kept."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.force_tables import fictitious_forces, in_space
from kinetruss.errors import InputError
from kinetruss.kernels.structure.applied import call_force, calling, compiled_force, no_force, python_force
from kinetruss.kernels.structure.structure import States
from kinetruss.mechanics import System
from kinetruss.mechanics.loads import Loads, case_loads
from kinetruss.model import nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray


class UserForce:
    """A force of the user. `call`: its address for kernels; `given`: there is one; `error`: the exception of its last call."""

    def __init__(self, system: System, function: Callable[..., Any] | None) -> None:
        self.error: BaseException | None = None
        self.given = function is not None
        self._system, self._function = system, function
        self._plain, self._compiled = False, None
        self.call: int = no_force
        if function is None:
            return
        try:
            found = compiled_force(function)
        except Exception as error:  # the compiler raises many kinds
            raise InputError(f"The compiled force cannot be used: {error}. Its form is f(t, x, v, out).") from error
        self._plain, self._compiled = found is None, found  # kept alive as long as its address is called
        self.call = python_force if found is None else int(found.address)

    @property
    def words(self) -> str:
        """What it is, for messages."""
        return getattr(self._function, "words", "a user force is given")

    @property
    def own(self) -> UserForce:
        """The force without what is added to it: fictitious forces of a base that rotates, feedback."""
        added = getattr(self._function, "own", None)
        return added.own if isinstance(added, UserForce) else self

    def again(self) -> UserForce:
        """A new one without a function of the user."""
        return UserForce(self._system, self._function.alone() if isinstance(self._function, ForceInBase) else None)

    def ready(self) -> None:
        """Clear the stored exception, and make this the force that kernels of this thread call."""
        self.error = None
        if self._plain:
            calling(self._push)

    def at(self, t: float, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
        """Forces (3 n,) at t, x (3 n,), v (3 n,), N."""
        out = np.zeros(self._system.x0.size)
        if self._plain:
            self._push(t, x, v, out)
        elif self.given:
            call_force(self.call, t, x, v, out)
        return out

    def _push(self, t: float, x: NDArray[np.float64], v: NDArray[np.float64], out: NDArray[np.float64]) -> None:
        """Add the forces that the function returns, NaN if it raises: steps that are too long are repeated with a shorter
        length.

        After an interrupt it is not called again.
        """
        if self._function is None or (self.error is not None and not isinstance(self.error, Exception)):
            out.fill(np.nan)
            return
        dim = self._system.dim
        try:
            found = self._function(t, *(np.array(y.reshape(-1, 3)[:, :dim]) for y in (x, v)))
            self._add(found, out.reshape(-1, 3)[:, :dim])
            self.error = None
        except BaseException as error:  # noqa: BLE001 - nothing may pass through compiled code; it is raised afterwards
            self.error = error
            out.fill(np.nan)

    def _add(self, found: Any, out: NDArray[np.float64]) -> None:
        if found is None:
            return
        if isinstance(found, Mapping):
            for name, force in found.items():
                if name not in self._system.nodes:
                    raise InputError(f"no node called {name!r}. {nearest(name, self._system.nodes)}")
                out[self._system.node_index(name)] += force
            return
        forces = np.asarray(found, float)
        if forces.shape != out.shape:
            raise InputError(f"it gave forces of shape {forces.shape}. Give {out.shape}, or node: force.")
        out += forces


class ForceInBase:
    """The fictitious forces (n, dim) of a base that rotates at t, x, v, and a force of the user with them."""

    words = "the base rotates"

    def __init__(self, system: System, loads: Loads, function: Callable[..., Any] | None) -> None:
        self.own = UserForce(system, function)
        self._system, self._loads = system, loads

    def alone(self) -> ForceInBase:
        """The same without the user's."""
        return ForceInBase(self._system, self._loads, None)

    def __call__(self, t: float, x: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
        """The forces on the nodes (n, dim) at t, x, v."""
        dim = self._system.dim
        flat = [np.pad(y, ((0, 0), (0, 3 - dim))).reshape(1, -1) for y in (x, v)]
        states = States(flat[0], flat[1], np.zeros_like(flat[0]))
        found = fictitious_forces(self._system, states, in_space(replace(self._loads, t=np.array([t])), states))[0]
        if self.own.given:
            found = found + self.own.at(t, flat[0][0], flat[1][0])
            if isinstance(self.own.error, BaseException):
                raise self.own.error
        return np.asarray(found.reshape(-1, 3)[:, :dim])


def user_force_of(
    system: System,
    function: Callable[..., Any] | None,
    x: NDArray[np.float64],
    v: NDArray[np.float64],
    load_case: str | None = None,
) -> UserForce:
    """Prepare a function of the user, and call it once at the start: positions x and velocities v (3 n,).

    In a base that rotates, the fictitious forces under the gravity of the load case are added.

    Raises
    ------
    InputError : no function, or one that raises or gives no finite forces already at the start.
    """
    if function is not None and not callable(function):
        raise InputError(f"user_force is {type(function).__name__}, not a function f(t, x, v).")
    loads = case_loads(system, np.zeros(1), load_case, rotating=True)
    user = UserForce(system, function if loads.base is None else ForceInBase(system, loads, function))
    user.ready()
    push = user.at(0.0, x.copy(), v.copy())
    if user.error is not None:
        error = user.error
        if not isinstance(error, Exception):
            raise error
        raise InputError(f"The user's force function fails at the start: {type(error).__name__}: {error}") from error
    if not np.isfinite(push).all():
        node = system.nodes[int(np.flatnonzero(~np.isfinite(push))[0]) // 3]
        raise InputError(f"The user's force on {node!r} is no finite number at the start. Give finite forces (N).")
    return user

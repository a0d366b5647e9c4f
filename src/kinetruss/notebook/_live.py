"""A live model in a notebook."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.errors import InputError
from kinetruss.model import Model

if TYPE_CHECKING:
    from kinetruss.notebook._widget import LiveModel

__all__ = ["live"]


def live(model: Model, *, height: int = 720, folder: str | Path | None = None) -> LiveModel:
    """The studio page as a widget: sliders, forces, reactions, motors, key frames. No server is started.

    Parameters
    ----------
    height : pixels. folder : the only place that Save writes to; by default nothing is written.

    Returns
    -------
    A widget; ``.values`` are the present drive values (m, rad), ``.session`` is its `studio.Session`, ``.session.model`` the
    model with its changes.

    Raises
    ------
    InputError : anywidget is not installed, or the model has no equilibrium or cannot be assembled.

    Examples
    --------
    >>> import kinetruss as kt
    >>> widget = kt.notebook.live(kt.library.vgt.triangular())
    >>> widget.values  # m
    {'actuator': 2.5}
    """
    target = None if folder is None else Path(folder).resolve()
    if target is not None and not target.is_dir():
        raise InputError(f"There is no folder {target}. Make it, or name another one.")
    found: LiveModel = _widget()(model, height, target)
    return found


def _widget() -> Any:
    try:
        from kinetruss.notebook._widget import LiveModel
    except ImportError as error:
        raise InputError(
            f"A live model in a notebook needs the package {error.name}. Install it: pip install 'kinetruss[notebook]'"
        ) from None
    return LiveModel

"""Write the page of a model, a motion or a run."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from kinetruss.results.store import whole_file
from kinetruss.viewer.pages.page import page
from kinetruss.viewer.scenes.scene import scene

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.results import Result
    from kinetruss.runs import RunResult
    from kinetruss.viewer.scenes.record import Mode

    Shown = Model | Result | RunResult

__all__ = ["write"]


def write(
    what: Shown,
    path: str | Path,
    *,
    beside: Shown | None = None,
    model: Model | None = None,
    case: str | None = None,
    frames: int = 600,
    modes: Sequence[Mode] = (),
    labels: Sequence[str] = (),
) -> Path:
    """Write one self-contained HTML page that shows a model, a run or another result with its model; the path written.

    Parameters
    ----------
    beside : a second one, shown next to the first with the same camera, time and colours.
    labels : names of the two. model, case, frames, modes : as for `scene`; modes are those of the first.

    Raises
    ------
    InputError : as `scene`. StoreError : the file cannot be written.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     kt.viewer.write(kt.library.vgt.triangular(), f"{folder}/truss.html").name
    'truss.html'
    """
    scenes = [scene(what, model=model, case=case, frames=frames, modes=modes)]
    if beside is not None:
        scenes.append(scene(beside, model=model, case=case, frames=frames))
    text = page(scenes, labels)
    target = Path(path)
    with whole_file(target) as draft:
        draft.write_text(text, encoding="utf-8")
    return target

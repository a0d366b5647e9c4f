"""One self-contained page: scenes, the program that shows them, its licence; nothing is loaded from a network."""

from __future__ import annotations

import base64
import html
import math
import zlib
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.display import POLICY, html_page, number, quantity, scale
from kinetruss.errors import InputError
from kinetruss.results.folder import whole_file
from kinetruss.viewer.packing import pack
from kinetruss.viewer.scenes import scene

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.results import Result
    from kinetruss.runs import RunResult
    from kinetruss.viewer.moving import Mode, Scene

    Shown = Model | Result | RunResult


def heading(channel: dict[str, Any], limits: Sequence[float]) -> str:
    """The heading: the coloured quantity with its unit."""
    unit = scale(limits[1], channel["unit"])[1]
    return f"{channel['label']}{f' ({unit})' if unit else ''}"


def ticks(channel: dict[str, Any], limits: Sequence[float]) -> list[str]:
    """Five numbers from the low to the high end; buckling margins are 1/utilisation - 1."""
    low, high = limits
    values = [low + part * (high - low) for part in (0, 0.25, 0.5, 0.75, 1)]
    if channel["scale"] == "margin":
        return [number(1 / value - 1 if value > 0 else math.inf, 2) for value in values]
    factor = scale(high, channel["unit"])[0]
    return [number(value * factor if abs(value) > 1e-12 * abs(high) else 0.0, 3) for value in values]


def ends(channel: dict[str, Any], largest: float, single: bool = False) -> tuple[str, str]:
    """Texts at the two ends. largest : value that is shown, below the end of the scale; single : of one instant only."""
    high = channel["high"]
    if high == "largest of the run":
        high = f"largest {'' if single else 'of the run '}{quantity(largest, channel['unit'])}"
    return channel["low"], high


# One self-contained page: scenes, the program that shows them, its licence. Nothing is loaded from elsewhere.

HERE = Path(__file__).parent

START = """
(async () => {
  try {
    const raw = atob(document.getElementById("kinetruss-program").textContent.trim());
    const bytes = Uint8Array.from(raw, (sign) => sign.charCodeAt(0));
    const { readable, writable } = new DecompressionStream("deflate");
    const writer = writable.getWriter();
    const text = new Response(readable).text();
    await writer.write(bytes).then(() => writer.close());
    const program = document.createElement("script");
    program.textContent = await text;
    document.head.append(program);
  } catch (error) {
    document.getElementById("kinetruss").textContent = "This page needs a browser of 2023 or newer. (" + error + ")";
  }
})();
"""


def page(scenes: Scene | Sequence[Scene], labels: Sequence[str] = (), title: str = "") -> str:
    """One self-contained HTML page that shows a scene, or two side by side.

    Parameters
    ----------
    labels : names of several scenes. title : of the page; by default that of the first scene.

    Raises
    ------
    InputError : no scene, or more than two.

    Examples
    --------
    >>> import kinetruss as kt
    >>> text = kt.viewer.page(kt.viewer.scene(kt.library.vgt.triangular()), title="Crane")
    >>> "<title>Crane" in text
    True
    """
    shown = list(scenes) if isinstance(scenes, Sequence) else [scenes]
    if not 1 <= len(shown) <= 2:
        raise InputError(f"{len(shown)} scenes: a page shows one, or two side by side.")
    names = [*labels, *(str(one.header["name"] or one.header["title"]) for one in shown[len(labels) :])]
    data = "".join(_data(one, name) for name, one in zip(names, shown, strict=True))
    words = title or str(shown[0].header["title"] or shown[0].header["name"] or "kinetruss")
    return _document(words, data, POLICY, "")


def live_page(title: str, hosts: Sequence[str] = (), still: Scene | None = None, *, draw: bool = False) -> str:
    """The same page without a scene: it gets its scene from a websocket of its server, or from the frame around it.

    hosts : e.g. ``127.0.0.1:8000``, the only hosts to which the page may connect. still : shown while nobody answers, as in a
    notebook that was exported as a page. draw : the page that draws a model.

    >>> import kinetruss as kt
    >>> "<title>Crane" in kt.viewer.live_page("Crane", hosts=["127.0.0.1:8000"])
    True
    """
    policy = f"{POLICY}; connect-src {' '.join(f'ws://{host}' for host in hosts)}" if hosts else POLICY
    data = "" if still is None else _data(still, "")
    live = "draw" if draw else "socket" if hosts else "frame"
    return _document(title or "kinetruss", data, policy, f' data-live="{live}"')


def film_page(still: Scene) -> str:
    """The page that draws pictures and films of a scene, as `kinetruss.viewer.pictures` asks it to."""
    return _document("kinetruss", _data(still, ""), POLICY, ' data-live="film"')


def _data(one: Scene, name: str) -> str:
    return f'<script type="text/plain" class="kinetruss-scene" data-label="{html.escape(name)}">{_text(pack(one))}</script>\n'


def _document(title: str, data: str, policy: str, live: str) -> str:
    body = f"""<div id="kinetruss"{live}>Opening ...</div>
<noscript>This page shows a structure in three dimensions; it needs JavaScript.</noscript>
{data}<!-- The program below contains three.js.
{licence()}-->
<script type="text/plain" id="kinetruss-program">{_program()}</script>
<script>{START}</script>"""
    return html_page(title, "", body, policy)


def licence() -> str:
    """The licence text of three.js."""
    return (HERE / "three.LICENSE.txt").read_text(encoding="utf-8")


@cache
def _program() -> str:
    return _text(zlib.compress((HERE / "bundle.js").read_bytes(), 9))


def _text(data: bytes) -> str:
    return base64.b64encode(data).decode("ascii")


# Write the page of a model, a motion or a run.


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

"""The widget: the studio page in a frame; its messages go to a session in this kernel."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from uuid import uuid4

import anywidget
import traitlets

from kinetruss.display import Markup, element
from kinetruss.model import Model
from kinetruss.notebook._show import framed
from kinetruss.studio import Session
from kinetruss.viewer import live_page, page, scene

__all__ = ["LiveModel"]

FRONT = """
// Carries messages between the page in a frame and the kernel. The still is for pages where no widget runs.
function render({ model, el }) {
  for (const still of document.querySelectorAll(`[data-still="${model.get("name")}"]`)) still.remove();
  const frame = document.createElement("iframe");
  const id = Math.random().toString(36).slice(2);
  frame.setAttribute("sandbox", "allow-scripts");
  frame.style.cssText = `width:100%;height:${model.get("height")}px;border:0`;
  const out = (event) => {
    if (event.source === frame.contentWindow && event.data?.kinetruss) model.send({ id, text: event.data.kinetruss });
  };
  const back = (message, buffers) => {
    if (message.id !== id) return;
    const [first] = buffers || [];
    const bytes = first && (first.buffer ? first.buffer.slice(first.byteOffset, first.byteOffset + first.byteLength) : first);
    frame.contentWindow?.postMessage({ kinetruss: bytes || message.text }, "*");
  };
  window.addEventListener("message", out);
  model.on("msg:custom", back);
  frame.srcdoc = model.get("page");
  el.append(frame);
  return () => {
    window.removeEventListener("message", out);
    model.off("msg:custom", back);
  };
}
export default { render };
"""


class LiveModel(anywidget.AnyWidget):
    """A live model. values : present drive values, m or rad."""

    _esm = FRONT
    name = traitlets.Unicode().tag(sync=True)
    page = traitlets.Unicode().tag(sync=True)
    height = traitlets.Int().tag(sync=True)
    values: Any = traitlets.Dict()

    def __init__(self, model: Model, height: int, folder: Path | None) -> None:
        self.session = Session(model, None, folder)
        still, name = scene(self.session.instant().forces, model=self.session.model), uuid4().hex
        self._still = element("div", Markup(framed(page(still, title=model.title), height)), data_still=name)
        super().__init__(
            page=live_page(model.title, still=still), name=name, height=height, values=dict(self.session.pose.values)
        )
        self.on_msg(self._heard)

    def _ipython_display_(self) -> None:
        """Show a still, and the widget, which takes the still away where it runs: no page is ever blank."""
        from IPython.display import display as untyped

        display: Any = untyped
        display({"text/html": self._still, "text/plain": "a still of the live model"}, raw=True)
        found = self._repr_mimebundle_()
        if found is not None:
            data, metadata = found if isinstance(found, tuple) else (found, {})
            display(data, metadata=metadata, raw=True)

    def _heard(self, _widget: Any, content: Any, _buffers: Any) -> None:
        """Answer one message of a page."""
        if not isinstance(content, dict) or not isinstance(content.get("text"), str):
            return
        found = self.session.answer(content["text"])
        header = {"id": content.get("id")}
        if isinstance(found, bytes):
            self.send(header, buffers=[found])
        else:
            self.send({**header, "text": json.dumps(found, ensure_ascii=False, allow_nan=False)})
        self.values = dict(self.session.pose.values)

// Starts the drawing page and keeps it connected.

import { Draw } from "./draw.js";
import style from "./editor.css";

export function startDraw(root) {
  const sheet = document.createElement("style");
  sheet.textContent = style;
  document.head.append(sheet);
  const draw = new Draw(root);
  window.kinetruss.draw = draw;
  const connect = () => {
    const socket = new WebSocket(`${location.origin.replace(/^http/, "ws")}${location.pathname}live?busy=1`); // told what an answer waits for
    socket.addEventListener("open", () => draw.open((text) => socket.send(text)));
    socket.addEventListener("message", ({ data }) => draw.hear(data));
    socket.addEventListener("close", () => draw.close(connect));
  };
  connect();
}

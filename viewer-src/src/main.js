// Starts the page: scenes in <script type="text/plain" class="kinetruss-scene"> elements become pictures.

import { App } from "./app.js";
import { startDraw } from "./editor/draw.js";
import { startFilm } from "./film.js";
import { startLive } from "./live.js";
import { fromBase64, readScene } from "./scene.js";
import style from "./style.css";
import { themeRules } from "./theme.js";

async function start() {
  const root = document.getElementById("kinetruss");
  if (!root) return;
  const sheet = document.createElement("style");
  sheet.textContent = `${themeRules()}\n${style}`;
  document.head.append(sheet);
  if (root.dataset.live === "draw") return startDraw(root);
  if (root.dataset.live === "film") return startFilm(root);
  if (root.dataset.live) return startLive(root);
  const sources = [...document.querySelectorAll("script.kinetruss-scene")];
  try {
    const scenes = [];
    for (const source of sources) scenes.push(await readScene(fromBase64(source.textContent)));
    const app = new App(root, scenes, sources.map((source) => source.dataset.label || ""));
    window.kinetruss.app = app;
    requestAnimationFrame(() => requestAnimationFrame(() => {
      window.kinetruss.ready = true;
      root.dataset.state = "ready";
    }));
  } catch (error) {
    window.kinetruss.failed = String(error?.message || error);
    root.dataset.state = "failed";
    root.textContent = `This page cannot be shown: ${window.kinetruss.failed} A browser of 2023 or newer with WebGL is needed.`;
  }
}

window.kinetruss = { ...window.kinetruss, ready: false, App, fromBase64, readScene };
start();

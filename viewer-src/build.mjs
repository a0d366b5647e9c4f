// Bundles the page into src/kinetruss/viewer/bundle.js, byte for byte the same from the same sources.

import { build } from "esbuild";
import { copyFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const out = process.argv[2] || here("../src/kinetruss/viewer/");

await build({
  entryPoints: [here("src/main.js")],
  outfile: `${out}/bundle.js`,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  loader: { ".css": "text" },
  legalComments: "inline",
  absWorkingDir: here("."),
});
await copyFile(here("node_modules/three/LICENSE"), `${out}/three.LICENSE.txt`);

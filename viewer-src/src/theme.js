// The colours of the page as variables of its style, from the palette of the package.

import { MISSING, OVER, THEMES } from "./display.js";

/** Rules that set the variables of both themes. */
export function themeRules() {
  const rule = (selector, colours, more) =>
    `${selector} { ${[...Object.entries(colours), ...more].map(([name, value]) => `--${name}: ${value};`).join(" ")} }`;
  return [
    rule("#kinetruss", THEMES.light, [["over", OVER], ["missing", MISSING], ["dark", 0]]),
    rule("#kinetruss[data-theme=\"dark\"]", THEMES.dark, [["dark", 1]]),
    "#kinetruss { color-scheme: light; } #kinetruss[data-theme=\"dark\"] { color-scheme: dark; }",
  ].join("\n");
}

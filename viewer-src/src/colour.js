// Colours of values: the rules of src/kinetruss/display/palettes.py. Words and numbers stand beside them.

import { DIVERGING, MISSING, OVER, SEQUENTIAL } from "./display.js";
import { roundUp } from "./format.js";

export function parse(hex) {
  const value = parseInt(hex.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

const TABLES = { diverging: DIVERGING.map(parse), sequential: SEQUENTIAL.map(parse) };

function mixed(table, t) {
  const place = Math.min(Math.max(t, 0), 1) * (table.length - 1);
  const k = Math.min(Math.floor(place), table.length - 2), f = place - k;
  return table[k].map((value, i) => value + f * (table[k + 1][i] - value));
}

/** sRGB triple 0..255 of a value on a scale with limits [low, high]. */
export function colourOf(scale, value, limits) {
  if (Number.isNaN(value)) return parse(MISSING);
  if (scale === "capacity" || scale === "margin") {
    return value > 1 ? parse(OVER) : mixed(TABLES.sequential, value / limits[1]);
  }
  const width = limits[1] - limits[0] || 1;
  return mixed(scale === "diverging" ? TABLES.diverging : TABLES.sequential, (value - limits[0]) / width);
}

/** Limits of the colours of a channel, from the ranges of all scenes shown: round numbers; of utilisation always 0 and 1. */
export function limitsOf(scale, ranges) {
  if (scale === "capacity" || scale === "margin") return [0, 1];
  const largest = roundUp(Math.max(...ranges.flat().map(Math.abs)));
  return scale === "diverging" ? [-largest, largest] : [0, largest];
}

/** The map of a scale as a CSS gradient from left to right. */
export function gradient(scale) {
  const table = scale === "diverging" ? DIVERGING : SEQUENTIAL;
  return `linear-gradient(to right, ${table.join(", ")})`;
}

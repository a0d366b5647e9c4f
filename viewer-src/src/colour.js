// Colours of values: the rules of src/kinetruss/display/palettes.py. Words and numbers stand beside them.

import { DIVERGING, MISSING, OVER, SEQUENTIAL } from "./display.js";

function parse(hex) {
  const value = parseInt(hex.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

const TABLES = { diverging: DIVERGING.map(parse), sequential: SEQUENTIAL.map(parse) };

function mixed(table, t) {
  const place = Math.min(Math.max(t, 0), 1) * (table.length - 1);
  const k = Math.min(Math.floor(place), table.length - 2), f = place - k;
  return table[k].map((value, i) => value + f * (table[k + 1][i] - value));
}

/** A colour with more grey in it: of a force that is not unique. */
export function greyer(colour) {
  return colour.map((value, i) => 0.45 * value + 0.55 * parse(MISSING)[i]);
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

/** Limits of the colours of a channel, from the ranges of all scenes shown. */
export function limitsOf(scale, ranges) {
  const low = Math.min(...ranges.map((r) => r[0])), high = Math.max(...ranges.map((r) => r[1]));
  if (scale === "diverging") {
    const largest = Math.max(Math.abs(low), Math.abs(high)) || 1;
    return [-largest, largest];
  }
  if (scale === "capacity" || scale === "margin") {
    return [0, high > 0.5 || !(high > 0) ? 1 : high]; // little used: what differs is shown, not one colour for all
  }
  return [0, high || 1];
}

/** The map of a scale as a CSS gradient from left to right. */
export function gradient(scale) {
  const table = scale === "diverging" ? DIVERGING : SEQUENTIAL;
  return `linear-gradient(to right, ${table.join(", ")})`;
}

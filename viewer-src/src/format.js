// Numbers that a person can read: the rules of src/kinetruss/display/numbers.py, which a test compares with these.

import { DIGITS, FLOORS, LONG, SHORT, UNITS } from "./display.js";

/** Factor and name of the unit in which the largest of some values is between 1 and 1000. */
export function scale(largest, unit) {
  const names = UNITS[unit], size = Math.abs(largest);
  if (!names) return [1, unit];
  if (!Number.isFinite(size) || size < (FLOORS[unit] || FLOORS[""])) return names.find((one) => one[0] === 1) || names[0];
  return names.findLast((one) => size * one[0] * (1 + 1e-9) >= 1) || names[0];
}

/** A number with some significant digits; a dash where there is none. */
export function number(value, digits = 4) {
  if (Number.isNaN(value)) return "-";
  const sign = value < 0 ? "-" : "";
  if (!Number.isFinite(value)) return `${sign}∞`;
  if (value === 0) return "0";
  const size = Math.abs(value);
  const [mantissa, exponent] = size.toExponential(digits - 1).split("e");
  const power = Number(exponent);
  if (power < SHORT || power >= Math.log10(LONG)) return `${sign}${trimmed(mantissa)}e${power}`;
  return sign + trimmed(size.toFixed(Math.max(0, digits - 1 - power)));
}

function trimmed(text) {
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

/** A value in an SI unit with the unit in which it is read. */
export function quantity(value, unit, digits = 0) {
  if (!Number.isFinite(value)) return number(value);
  const [factor, name] = scale(value, unit);
  const shown = UNITS[unit] && Math.abs(value) < (FLOORS[unit] || FLOORS[""]) ? 0 : value;
  return `${number(shown * factor, digits || DIGITS[unit] || DIGITS[""])} ${name}`.trimEnd();
}

/** A time of a history, always in seconds. */
export function instant(time) {
  return Number.isFinite(time) ? `${number(time)} s` : "-";
}

/** The largest of 1, 2, 5 times a power of ten that is not above a size. */
export function niceStep(size) {
  const power = 10 ** Math.floor(Math.log10(size));
  const factor = [5, 2, 1].find((one) => one * power <= size * (1 + 1e-9)) || 1;
  return factor * power;
}

/** What a channel's value means, in words; margins are 1/utilisation - 1. */
export function channelText(channel, value, short = false) {
  if (Number.isNaN(value)) return short ? "-" : ["capacity", "margin"].includes(channel.scale) ? "not checked" : "not known";
  if (channel.scale === "margin") {
    if (value <= 0) return short ? "∞" : "∞ (no compression)";
    return number(1 / value - 1, 3);
  }
  return quantity(value, channel.unit);
}

// Numbers that a person can read: the rules of src/kinetruss/display/numbers.py, which a test compares with these.

import { DIGIT, DIGITS, ENDS, FAR, FLOORS, LONG, POINT, ROUND_OFF, SHORT, UNITS } from "./display.js";

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

/** Texts of the values of a column, in one unit with one number of decimals, and the name of the unit. */
export function column(values, unit, digits = 0) {
  const sizes = values.filter(Number.isFinite).map(Math.abs);
  const largest = sizes.reduce((best, size) => Math.max(best, size), 0);
  return columnUpTo(largest, values, unit, digits);
}

/** The same for values of a column whose largest is known; `steady`: with zeros at the end, so that decimals do not come and go. */
export function columnUpTo(largest, values, unit, digits = 0, steady = false) {
  const [factor, name] = scale(largest, unit);
  const floor = Math.max(UNITS[unit] ? FLOORS[unit] || FLOORS[""] : 0, ROUND_OFF * largest);
  const top = largest * factor, power = top > 0 ? Math.floor(Math.log10(top) + 1e-9) : 0;
  const wanted = digits || DIGITS[unit] || DIGITS[""];
  const least = values.reduce((best, value) => (Number.isFinite(value) && Math.abs(value) > floor ? Math.min(best, Math.abs(value)) : best), 1);
  if (power < SHORT || power >= Math.log10(LONG) || (name === "" && least < 10 ** SHORT)) {
    return [values.map((value) => number(Math.abs(value) < floor ? 0 : value * factor, digits || DIGITS[""])), name];
  }
  const share = unit === "%" && !digits;
  let decimals = share ? 1 : Math.max(0, wanted - 1 - power);
  const shown = values.filter((value) => Number.isFinite(value) && Math.abs(value) >= floor);
  while (decimals && !share && !steady && shown.every((value) => fixed(value * factor, decimals).endsWith("0"))) decimals--;
  const zero = `0${decimals ? POINT + DIGIT.repeat(decimals) : ""}`;
  return [values.map((value) => (!Number.isFinite(value) ? number(value) : Math.abs(value) < floor || !value ? zero : fixed(value * factor, decimals))), name];
}

function fixed(value, decimals) {
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && /[1-9]/.test(text) ? `-${text}` : text;
}

/** A margin: two decimals, and no more than that it is large. */
export function margin(value) {
  if (!Number.isFinite(value)) return number(value);
  return value > FAR ? `> ${FAR}` : fixed(value, 2);
}

/** The end of a scale for values up to a size: the next number whose quarters are round. */
export function roundUp(size) {
  if (!(Number.isFinite(size) && size > 0)) return 1;
  const power = Math.floor(Math.log10(size));
  return [...ENDS, 12].map((one) => Number(`${one}e${power}`)).find((one) => one >= size * (1 - 1e-9));
}

/** Round numbers between two, at most so many: multiples of 1, 2 or 5 times a power of ten. */
export function ticks(low, high, most = 5) {
  if (!(Number.isFinite(low) && Number.isFinite(high) && high > low)) return [low];
  const power = Math.floor(Math.log10((high - low) / most));
  for (let k = 0; k < 9; k++) {
    const factor = [1, 2, 5][k % 3], shift = power + Math.floor(k / 3), step = Number(`${factor}e${shift}`);
    const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
    if (last - first < most) return Array.from({ length: last - first + 1 }, (_, n) => Number(`${(first + n) * factor}e${shift}`));
  }
  return [low];
}

/** The largest of 1, 2, 5 times a power of ten that is not above a size. */
export function niceStep(size) {
  const power = 10 ** Math.floor(Math.log10(size));
  const factor = [5, 2, 1].find((one) => one * power <= size * (1 + 1e-9)) || 1;
  return factor * power;
}

/** What a channel's value means, in words; margins are 1/utilisation - 1. */
export function channelText(channel, value, short = false) {
  if (Number.isNaN(value)) return short ? "-" : held(channel) ? "not checked" : "not known";
  if (channel.scale === "margin") {
    if (value <= 0) return short ? "∞" : "∞ (no compression)";
    return margin(1 / value - 1);
  }
  return quantity(value, channel.unit);
}

/** Whether a channel is held against a capacity. */
export function held(channel) {
  return channel.scale === "capacity" || channel.scale === "margin";
}

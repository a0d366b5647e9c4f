// Numbers that a person can read.

const PREFIXES = { "-9": "n", "-6": "µ", "-3": "m", 0: "", 3: "k", 6: "M", 9: "G" };
const SCALED = new Set(["N", "Pa", "N m", "W", "J", "m", "s", "m/s", "m/s²"]);

/** Factor and unit with a prefix that put the largest value between 1 and 1000. */
export function scale(largest, unit) {
  const size = Math.abs(largest);
  if (!SCALED.has(unit) || !(size > 1e-12) || !Number.isFinite(size)) return [1, unit];
  let power = 3 * Math.floor(Math.log10(size * (1 + 1e-9)) / 3);
  if (unit[0] === "m" || unit === "s") power = Math.min(0, power);
  power = Math.max(-9, Math.min(9, power));
  return [10 ** -power, PREFIXES[power] + unit];
}

/** A number with some significant digits; a dash where there is none. */
export function number(value, digits = 4) {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(digits - 1) : plain(value, digits);
  return text.replace("-", "−").replace("e+", "e").replace("e-", "e−");
}

function plain(value, digits) {
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(value))));
  return value.toFixed(Math.min(decimals, 12));
}

/** A number with its unit. */
export function quantity(value, unit, digits = 4) {
  const [factor, shown] = scale(value, unit);
  return `${number(value * factor, digits)}${shown ? ` ${shown}` : ""}`;
}

/** The largest of 1, 2, 5 times a power of ten that is not above a size. */
export function niceStep(size) {
  const power = 10 ** Math.floor(Math.log10(size));
  const factor = [5, 2, 1].find((one) => one * power <= size * (1 + 1e-9)) || 1;
  return factor * power;
}

/** What a channel's value means, in words; margins are 1/utilisation - 1. */
export function channelText(channel, value, short = false) {
  if (Number.isNaN(value)) return short ? "–" : ["capacity", "margin"].includes(channel.scale) ? "not checked" : "not known";
  if (channel.scale === "margin") {
    if (value <= 0) return short ? "∞" : "∞ (no compression)";
    return number(1 / value - 1, 3);
  }
  return quantity(value, channel.unit);
}

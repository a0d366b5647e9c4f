// Small plots on a canvas: curves over time, diagrams along a member.

import { OVER, THEMES } from "./display.js";
import { number, scale, ticks } from "./format.js";

const PAD = { left: 52, right: 10, top: 18, bottom: 18 };
const PENS = Object.fromEntries(Object.entries(THEMES).map(([theme, colours]) => [theme, [1, 2, 3].map((k) => colours[`pen-${k}`])]));

/**
 * Draw curves {x, y, label, dashed} into a canvas.
 * options: unit, xUnit, title, cursor (x), limit (y), fill (to the zero line).
 * Returns where values are: {x(value), y(value)} in pixels.
 */
export function plot(canvas, curves, options = {}) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth || 300, height = canvas.clientHeight || 110;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const pen = canvas.getContext("2d");
  pen.scale(ratio, ratio);
  const style = getComputedStyle(canvas);
  const ink = style.color, faint = style.getPropertyValue("--line").trim() || "#ccc";
  const theme = style.getPropertyValue("--dark").trim() === "1" ? "dark" : "light";
  const frame = frameOf(curves, options, width, height);
  pen.font = "11px system-ui, sans-serif";
  axes(pen, frame, options, ink, faint);
  curves.forEach((curve, k) => line(pen, frame, curve, PENS[theme][k % 3], options.fill));
  if (Number.isFinite(options.limit)) level(pen, frame, options.limit, theme === "dark" ? THEMES.dark.alarm : OVER);
  if (options.cursor !== undefined) upright(pen, frame, options.cursor, ink);
  legend(pen, frame, curves, PENS[theme], ink);
  return frame;
}

function frameOf(curves, options, width, height) {
  let [x0, x1, y0, y1] = [Infinity, -Infinity, 0, 0];
  for (const { x, y } of curves) {
    for (let i = 0; i < x.length; i++) {
      if (x[i] < x0) x0 = x[i];
      if (x[i] > x1) x1 = x[i];
      if (y[i] < y0 && Number.isFinite(y[i])) y0 = y[i];
      if (y[i] > y1 && Number.isFinite(y[i])) y1 = y[i];
    }
  }
  const largest = Math.max(Math.abs(y0), Math.abs(y1));
  if (Number.isFinite(options.limit) && options.limit < 2.5 * largest) y1 = Math.max(y1, options.limit);
  if (y1 - y0 < 1e-12 * (largest || 1) || y0 === y1) [y0, y1] = [Math.min(y0, -1e-9), Math.max(y1, 1e-9)];
  const room = 0.06 * (y1 - y0);
  if (y0 < 0) y0 -= room;
  if (y1 > 0) y1 += room;
  const [factor, unit] = scale(largest, options.unit || "");
  const w = width - PAD.left - PAD.right, h = height - PAD.top - PAD.bottom;
  return {
    x0, x1, y0, y1, largest, factor, unit, width, height,
    x: (value) => PAD.left + ((value - x0) / (x1 - x0 || 1)) * w,
    y: (value) => PAD.top + (1 - (value - y0) / (y1 - y0)) * h,
  };
}

function axes(pen, frame, options, ink, faint) {
  pen.strokeStyle = faint;
  pen.fillStyle = ink;
  pen.lineWidth = 1;
  const [left, right] = [PAD.left, frame.width - PAD.right];
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  const { factor } = frame;
  for (const y of frame.largest ? ticks(frame.y0 * factor, frame.y1 * factor, 4) : [0]) {
    const at = Math.round(frame.y(y / factor)) + 0.5;
    pen.beginPath();
    pen.moveTo(left, at);
    pen.lineTo(right, at);
    pen.stroke();
    pen.fillText(number(y), left - 5, at);
  }
  pen.textBaseline = "alphabetic";
  pen.textAlign = "center";
  const words = ` ${options.xUnit || "s"}`, room = pen.measureText(words).width;
  for (const x of ticks(frame.x0, frame.x1, 5)) {
    const text = number(x), half = pen.measureText(text).width / 2, at = Math.min(Math.max(frame.x(x), left + half), right - half);
    if (at + half < right - room || x === 0) pen.fillText(text, at, frame.height - 4);
  }
  pen.textAlign = "right";
  pen.fillText(words, right, frame.height - 4);
  pen.textAlign = "left";
  pen.fillText(`${options.title || ""}${frame.unit ? ` (${frame.unit})` : ""}`, left, 11);
}

function line(pen, frame, curve, colour, filled) {
  const { x, y } = curve;
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = 1.6;
  pen.setLineDash(curve.dashed ? [5, 3] : []);
  for (const [first, last] of stretches(y)) {
    pen.beginPath();
    for (let i = first; i <= last; i++) pen[i > first ? "lineTo" : "moveTo"](frame.x(x[i]), frame.y(y[i]));
    pen.stroke();
    if (!filled) continue;
    pen.lineTo(frame.x(x[last]), frame.y(0));
    pen.lineTo(frame.x(x[first]), frame.y(0));
    pen.globalAlpha = 0.12;
    pen.fill();
    pen.globalAlpha = 1;
  }
  pen.setLineDash([]);
}

/** First and last index of every stretch of finite values. */
function stretches(y) {
  const found = [];
  for (let i = 0; i < y.length; i++) {
    if (!Number.isFinite(y[i])) continue;
    const open = found.length && found[found.length - 1][1] === i - 1;
    if (open) found[found.length - 1][1] = i;
    else found.push([i, i]);
  }
  return found;
}

function level(pen, frame, value, colour) {
  if (value > frame.y1) return;
  pen.strokeStyle = colour;
  pen.setLineDash([4, 3]);
  pen.beginPath();
  pen.moveTo(PAD.left, frame.y(value));
  pen.lineTo(frame.width - PAD.right, frame.y(value));
  pen.stroke();
  pen.setLineDash([]);
}

function upright(pen, frame, value, ink) {
  pen.strokeStyle = ink;
  pen.globalAlpha = 0.6;
  pen.beginPath();
  pen.moveTo(frame.x(value), PAD.top);
  pen.lineTo(frame.x(value), frame.height - PAD.bottom);
  pen.stroke();
  pen.globalAlpha = 1;
}

function legend(pen, frame, curves, pens, ink) {
  let at = frame.width - PAD.right;
  pen.textAlign = "right";
  for (let k = curves.length - 1; k >= 0; k--) {
    const { label } = curves[k];
    if (!label) continue;
    pen.fillStyle = ink;
    pen.fillText(label, at, 11);
    at -= pen.measureText(label).width + 4;
    pen.fillStyle = pens[k % pens.length];
    pen.fillRect(at - 12, 6, 12, 3);
    at -= 20;
  }
}

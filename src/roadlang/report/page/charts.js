"use strict";
// Elements, numbers and plots, for the other scripts of the page.

const SVG = "http://www.w3.org/2000/svg";

function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

function draw(tag, attributes = {}, ...children) {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

// Three significant digits, with a minus sign.
function shown(value, unit = "") {
  if (value === null || value === undefined) return "\u2013";
  const size = Math.abs(value);
  let text = size >= 1000 ? Math.round(value).toLocaleString("en") : String(+value.toPrecision(3));
  text = text.replace("-", "\u2212");
  return unit ? `${text}\u00a0${unit}` : text;
}

// Whole numbers, each the difference from the one before, as numbers.
function undelta(steps, scale) {
  let sum = 0;
  return steps.map((step) => (sum += step) / scale);
}

// The largest index with values[index] <= value, of ascending values.
function indexBefore(values, value) {
  let low = 0;
  let high = values.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (values[middle] <= value) low = middle;
    else high = middle - 1;
  }
  return low;
}

function valueAt(times, values, time) {
  const index = indexBefore(times, time);
  const after = Math.min(index + 1, times.length - 1);
  const span = times[after] - times[index];
  const share = span > 0 ? Math.min(Math.max((time - times[index]) / span, 0), 1) : 0;
  const [a, b] = [values[index], values[after]];
  return a === null || b === null || a === undefined ? null : a + share * (b - a);
}

function limits(values, also = []) {
  const known = values.filter((value) => value !== null).concat(also);
  const [low, high] = [Math.min(...known), Math.max(...known)];
  const room = high > low ? 0.08 * (high - low) : 1;
  return [low - room, high + room];
}

// Pixels across a digit of the labels beside a curve.
const LETTER = 6.7;

// A curve of `values` over `across`, with a cursor that follows the time of the drive. A click or a
// drag sets the time.
class Plot {
  constructor({ title, note, across, values, times, acrossUnit, unit, zero, onTime }) {
    Object.assign(this, { across, values, times, acrossUnit, unit, zero, onTime });
    this.reading = make("span", { class: "reading" });
    const caption = make("figcaption", {}, this.reading, make("strong", {}, title));
    if (note) caption.append(make("span", { class: "formula" }, note));
    this.svg = draw("svg", { role: "img", "aria-label": title });
    this.node = make("figure", { class: "plot" }, caption, this.svg);
    const pick = (event) => {
      if (event.type === "pointermove" && !(event.buttons & 1)) return;
      this.pick(event.clientX - this.svg.getBoundingClientRect().left);
    };
    this.svg.addEventListener("pointerdown", pick);
    this.svg.addEventListener("pointermove", pick);
  }

  render() {
    const wide = this.node.clientWidth || 340;
    const tall = 120;
    const known = this.values.filter((value) => value !== null);
    const ticks = this.zero ? [0, Math.min(...known), Math.max(...known)] : [Math.min(...known), Math.max(...known)];
    const longest = Math.max(...ticks.map((tick) => shown(tick).length));
    const box = { left: Math.max(42, 8 + LETTER * longest), right: wide - 6, top: 6, bottom: tall - 18 };
    const [x0, x1] = [Math.min(...this.across), Math.max(...this.across)];
    const [y0, y1] = limits(this.values, this.zero ? [0] : []);
    this.x = (value) => box.left + ((value - x0) / (x1 - x0 || 1)) * (box.right - box.left);
    this.y = (value) => box.bottom - ((value - y0) / (y1 - y0)) * (box.bottom - box.top);
    this.svg.setAttribute("viewBox", `0 0 ${wide} ${tall}`);
    this.svg.setAttribute("height", tall);
    const parts = [];
    if (this.zero && y0 < 0) {
      const floor = this.y(Math.max(0, y0));
      const height = Math.max(box.bottom - floor, 0);
      const below = { x: box.left, y: floor, width: box.right - box.left, height, class: "below" };
      parts.push(draw("rect", below));
    }
    const base = this.zero ? this.y(0) : box.bottom;
    parts.push(draw("path", { d: `M${box.left} ${base}H${box.right}`, class: "zero" }));
    parts.push(draw("path", { d: this.path(), class: "curve" }));
    const placed = [];
    for (const tick of ticks) {
      const up = this.y(tick);
      if (placed.some((other) => Math.abs(other - up) < 13)) continue;
      placed.push(up);
      parts.push(this.label(shown(tick), box.left - 5, up + 4, "end"));
    }
    parts.push(this.label(shown(x0, this.acrossUnit), box.left, tall - 4, "start"));
    parts.push(this.label(shown(x1, this.acrossUnit), box.right, tall - 4, "end"));
    this.cursor = draw("path", { class: "cursor" });
    this.dot = draw("circle", { r: 3.5, class: "dot" });
    this.svg.replaceChildren(...parts, this.cursor, this.dot);
    this.span = box;
  }

  label(words, x, y, anchor) {
    const node = draw("text", { x, y, "text-anchor": anchor });
    node.textContent = words;
    return node;
  }

  path() {
    let text = "";
    let pen = "M";
    this.values.forEach((value, index) => {
      if (value === null || this.across[index] === null) {
        pen = "M";
        return;
      }
      text += `${pen}${this.x(this.across[index]).toFixed(1)} ${this.y(value).toFixed(1)}`;
      pen = "L";
    });
    return text;
  }

  show(time) {
    const value = valueAt(this.times, this.values, time);
    const at = valueAt(this.times, this.across, time);
    const isKnown = value !== null && at !== null;
    this.dot.style.display = this.cursor.style.display = isKnown ? "" : "none";
    this.reading.textContent = isKnown ? shown(value, this.unit) : "";
    if (!isKnown) return;
    const [x, y] = [this.x(at), this.y(value)];
    this.cursor.setAttribute("d", `M${x} ${this.span.top}V${this.span.bottom}`);
    this.dot.setAttribute("cx", x);
    this.dot.setAttribute("cy", y);
  }

  pick(pixel) {
    let best = 0;
    this.across.forEach((value, index) => {
      if (Math.abs(this.x(value) - pixel) < Math.abs(this.x(this.across[best]) - pixel)) best = index;
    });
    this.onTime(this.times[best]);
  }
}

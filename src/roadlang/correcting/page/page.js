"use strict";

const SVG = "http://www.w3.org/2000/svg";
const DOUBTFUL = 0.999;
const at = id => document.getElementById(id);

/* What is shown. `corrections` is replaced, never changed, so that undo keeps the ones before. */
const page = {
  found: [], roads: [], missed: [], corrections: { drawn: [], dismissed: [], confirmed: [] },
  before: [], after: [], saved: "", chosen: null, line: null, cut: null, size: [1, 1],
  box: [0, 0, 1, 1], asked: 0,
};

function element(name, attributes, parent) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (parent) parent.append(made);
  return made;
}

const path = points => points.map(([x, y], k) => `${k ? "L" : "M"}${x},${y}`).join("");

function color(sure) {
  const stops = [[0, [229, 57, 53]], [0.6, [255, 179, 0]], [1, [0, 229, 255]]];
  for (let k = 1; k < stops.length; k++) {
    const [[low, a], [high, b]] = [stops[k - 1], stops[k]];
    if (sure <= high) {
      const t = (sure - low) / (high - low);
      return `rgb(${a.map((p, i) => Math.round(p + t * (b[i] - p))).join(",")})`;
    }
  }
  return "rgb(0,229,255)";
}

async function ask(name, content) {
  const options = content === undefined ? {} : {
    method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(content),
  };
  const answer = await fetch(name, options);
  if (!answer.ok) throw new Error(`${answer.status} ${answer.statusText}`);
  return answer.json();
}

function say(words, bad = false) {
  at("message").textContent = words;
  at("message").className = bad ? "bad" : "";
}

/* Pixels of the screen to one pixel of the picture. */
const zoom = () => {
  const { width, height } = at("view").getBoundingClientRect();
  return Math.min(width / page.box[2], height / page.box[3]);
};

function place(event) {
  const matrix = at("view").getScreenCTM().inverse();
  const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
  return [Math.round(point.x * 10) / 10, Math.round(point.y * 10) / 10];
}

function show(box) {
  page.box = box;
  at("view").setAttribute("viewBox", box.join(" "));
  draw();
}

const fit = () => show([-0.5, -0.5, ...page.size]);

function zoomAt([x, y], factor) {
  const [left, top, wide, tall] = page.box;
  const least = Math.min(...page.size) / 200, most = Math.max(...page.size) * 4;
  if (Math.min(wide, tall) * factor < least || Math.max(wide, tall) * factor > most) return;
  show([x - (x - left) * factor, y - (y - top) * factor, wide * factor, tall * factor]);
}

function draw() {
  const thin = 1.8 / zoom();
  at("roads").replaceChildren();
  for (const road of page.roads) {
    const group = element("g", { "data-road": road.id, class: road === page.chosen ? "chosen" : "" }, at("roads"));
    const line = { d: path(road.points), stroke: color(road.confidence) };
    element("path", { ...line, class: "surface", "stroke-width": road.width }, group);
    element("path", { ...line, class: "center", "stroke-width": thin }, group);
    const hit = element("path", { d: line.d, class: "hit", "stroke-width": Math.max(road.width, 14 / zoom()) }, group);
    element("title", {}, hit).textContent = `${Math.round(road.confidence * 100)}% sure`;
  }
  at("lost").replaceChildren();
  if (page.corrections.dismissed.length) {
    const near = page.roads.flatMap(road => road.points);
    for (const road of page.found) {
      for (const part of lost(road, near)) {
        element("path", { d: path(part), "stroke-width": thin * 1.4, "stroke-dasharray": `${6 / zoom()} ${5 / zoom()}` }, at("lost"));
      }
    }
  }
  at("marks").replaceChildren();
  for (const [x, y] of page.missed) {
    element("circle", { cx: x, cy: y, r: 6 / zoom(), fill: "none", stroke: "#ff5252", "stroke-width": thin }, at("marks"));
  }
  at("drawing").replaceChildren();
  const line = page.line || page.cut;
  if (line && line.length) {
    element("path", { d: path(line), "stroke-width": thin * 1.4 }, at("drawing"));
    for (const [x, y] of line) element("circle", { cx: x, cy: y, r: 4 / zoom() }, at("drawing"));
  }
}

/* The parts of a found road along which there is no road any more. */
function lost(road, near) {
  const parts = [];
  let part = [];
  for (const [x, y] of road.points) {
    if (near.some(([a, b]) => Math.hypot(a - x, b - y) < 3)) {
      if (part.length > 1) parts.push(part);
      part = [];
    } else part.push([x, y]);
  }
  if (part.length > 1) parts.push(part);
  return parts;
}

function describe() {
  const { drawn, dismissed, confirmed } = page.corrections;
  at("corrections").replaceChildren();
  const add = (words, key, index, points) => {
    const item = document.createElement("li"), span = document.createElement("span");
    const button = document.createElement("button");
    span.textContent = words;
    span.onclick = () => look(points);
    button.textContent = "\u00d7";
    button.setAttribute("aria-label", `Remove the correction: ${words}`);
    button.onclick = () => change({ ...page.corrections, [key]: page.corrections[key].filter((_, k) => k !== index) });
    item.append(span, button);
    at("corrections").append(item);
  };
  drawn.forEach((line, k) => add(`drawn, ${line.length} points`, "drawn", k, line));
  dismissed.forEach((line, k) => add(line.length > 1 ? "part dismissed" : "road dismissed", "dismissed", k, line));
  confirmed.forEach((point, k) => add("road confirmed", "confirmed", k, [point]));
  at("undo").disabled = !page.before.length;
  at("redo").disabled = !page.after.length;
  at("save").disabled = JSON.stringify(page.corrections) === page.saved;
  const chosen = page.chosen;
  at("selected").hidden = !chosen;
  if (chosen) at("road").textContent = `Road ${chosen.id}: ${Math.round(length(chosen.points))} px, ${Math.round(chosen.confidence * 100)}% sure`;
  at("draw").setAttribute("aria-pressed", page.line !== null);
  at("part").setAttribute("aria-pressed", page.cut !== null);
  at("view").classList.toggle("drawing", page.line !== null);
  at("view").classList.toggle("cutting", page.cut !== null);
  at("hint").textContent = page.line ? "Click the points of the road; Enter ends it, Esc stops."
    : page.cut ? `Click the ${page.cut.length ? "end" : "start"} of the part that is not a road; Esc stops.` : "";
}

const length = points => points.slice(1).reduce((sum, [x, y], k) => sum + Math.hypot(x - points[k][0], y - points[k][1]), 0);

/* Shows a place: the whole of it, with some room around. */
function look(points) {
  const xs = points.map(p => p[0]), ys = points.map(p => p[1]);
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const wide = Math.max(...xs) - left, tall = Math.max(...ys) - top;
  const side = Math.max(wide * 1.6, tall * 1.6, Math.max(...page.size) / 6);
  show([left + wide / 2 - side / 2, top + tall / 2 - side / 2, side, side]);
}

/* A place in the middle of a road: what is written for the whole of it. */
const middle = road => road.points[Math.floor(road.points.length / 2)];

async function change(corrections) {
  page.before.push(page.corrections);
  page.after = [];
  await use(corrections);
}

async function use(corrections) {
  const number = ++page.asked, before = page.corrections;
  page.corrections = corrections;
  page.chosen = null;
  describe();
  let answer;
  try {
    answer = await ask("roads", corrections);
  } catch (error) {
    say(`roadlang no longer answers (${error.message}).`, true);
    return;
  }
  if (number !== page.asked) return;
  if (answer.error) {
    page.corrections = before;
    if (page.before[page.before.length - 1] === before) page.before.pop();
    say(answer.error, true);
  } else {
    page.roads = answer.roads;
    page.missed = answer.missed;
    say(answer.missed.length ? "No road is near the places in red circles." : "", true);
  }
  draw();
  describe();
}

function choose(road) {
  page.chosen = road;
  draw();
  describe();
}

function confirm() {
  if (page.chosen) return change({ ...page.corrections, confirmed: [...page.corrections.confirmed, middle(page.chosen)] });
}

function dismiss() {
  if (page.chosen) return change({ ...page.corrections, dismissed: [...page.corrections.dismissed, [middle(page.chosen)]] });
}

function stop() {
  page.line = page.cut = null;
  choose(null);
}

function startDrawing() {
  stop();
  page.line = [];
  describe();
}

function startCutting() {
  page.cut = [];
  describe();
}

function endDrawing() {
  const line = page.line.filter(([x, y], k, all) => !k || Math.hypot(x - all[k - 1][0], y - all[k - 1][1]) > 0.5);
  stop();
  if (line.length > 1) return change({ ...page.corrections, drawn: [...page.corrections.drawn, line] });
}

/* The least certain road that is not sure, the next one at each call. */
function nextDoubtful() {
  const doubtful = page.roads.filter(road => road.confidence < DOUBTFUL).sort((a, b) => a.confidence - b.confidence);
  if (!doubtful.length) return say("No road is doubtful.");
  const road = doubtful[(doubtful.indexOf(page.chosen) + 1) % doubtful.length];
  look(road.points);
  choose(road);
}

function undo() {
  if (!page.before.length) return;
  page.after.push(page.corrections);
  return use(page.before.pop());
}

function redo() {
  if (!page.after.length) return;
  page.before.push(page.corrections);
  return use(page.after.pop());
}

async function save() {
  try {
    const answer = await ask("save", page.corrections);
    if (answer.error) return say(answer.error, true);
    page.saved = JSON.stringify(page.corrections);
    say(`Saved in ${page.file}.`);
  } catch (error) {
    say(`Not saved: roadlang no longer answers (${error.message}).`, true);
  }
  describe();
}

async function close() {
  if (JSON.stringify(page.corrections) !== page.saved && !window.confirm("Close without saving?")) return;
  page.saved = JSON.stringify(page.corrections);
  await ask("done", page.corrections);
  document.body.textContent = "Done. You may close this page.";
}

function clicked(event) {
  if (page.line) {
    page.line.push(place(event));
    draw();
    describe();
  } else if (page.cut) {
    page.cut.push(place(event));
    draw();
    describe();
    if (page.cut.length === 2) {
      const part = page.cut;
      page.cut = null;
      change({ ...page.corrections, dismissed: [...page.corrections.dismissed, part] });
    }
  } else {
    const group = event.target.closest("[data-road]");
    choose(group ? page.roads.find(road => String(road.id) === group.dataset.road) : null);
  }
}

/* A press that moves drags the picture; one that does not is a click. */
let press = null;
at("view").addEventListener("pointerdown", event => {
  press = { x: event.clientX, y: event.clientY, box: page.box, moved: false, target: event.target };
  at("view").focus();
});
window.addEventListener("pointermove", event => {
  if (!press) return;
  const [dx, dy] = [event.clientX - press.x, event.clientY - press.y];
  if (!press.moved && Math.hypot(dx, dy) < 4) return;
  press.moved = true;
  at("view").classList.add("dragging");
  const scale = zoom();
  show([press.box[0] - dx / scale, press.box[1] - dy / scale, press.box[2], press.box[3]]);
});
/* Not a `click`: there is none where the roads were drawn anew between press and release. */
window.addEventListener("pointerup", event => {
  at("view").classList.remove("dragging");
  if (press && !press.moved && event.button === 0) clicked(event);
  press = null;
});
at("view").addEventListener("dblclick", () => {
  if (page.line) endDrawing();
});
at("view").addEventListener("wheel", event => {
  event.preventDefault();
  zoomAt(place(event), Math.exp(event.deltaY * 0.0015));
}, { passive: false });
window.addEventListener("resize", draw);
window.addEventListener("beforeunload", event => {
  if (JSON.stringify(page.corrections) !== page.saved) event.preventDefault();
});

const KEYS = {
  d: startDrawing, n: nextDoubtful, f: fit, c: confirm, x: dismiss, Escape: stop,
  p: () => page.chosen && startCutting(),
  Enter: () => page.line && endDrawing(),
  Backspace: () => { if (page.line) { page.line.pop(); draw(); } },
};
window.addEventListener("keydown", event => {
  if (event.target.closest("button, summary") && event.key === "Enter") return;
  if (event.ctrlKey || event.metaKey) {
    const known = { z: event.shiftKey ? redo : undo, y: redo, s: save }[event.key.toLowerCase()];
    if (known) { event.preventDefault(); known(); }
  } else if (!event.altKey && KEYS[event.key]) KEYS[event.key]();
});
for (const [id, action] of Object.entries({
  draw: () => (page.line ? stop() : startDrawing()), doubtful: nextDoubtful, fit, undo, redo, save, close,
  confirm, dismiss, part: startCutting,
})) at(id).onclick = action;

ask("start").then(start => {
  Object.assign(page, {
    found: start.found, roads: start.roads || [], missed: start.missed || [], file: start.file,
    corrections: start.corrections, saved: JSON.stringify(start.corrections), size: [start.width, start.height],
  });
  element("image", { href: "picture", x: -0.5, y: -0.5, width: start.width, height: start.height }, at("picture"));
  at("title").textContent = `Roads of \u201c${start.network}\u201d`;
  document.title = `${start.network} \u2013 ${start.file}`;
  at("remarks").textContent = start.remarks.slice(0, 4).join("; ");
  if (start.error) say(start.error, true);
  fit();
  describe();
}).catch(error => say(`The roads could not be read (${error.message}).`, true));

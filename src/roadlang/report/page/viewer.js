"use strict";
// The drive that is shown: its map, its time, its plots.

const DATA = JSON.parse(document.getElementById("data").textContent);
const COLORS = ["#1c7ed6", "#e8590c", "#2f9e44", "#9c36b5", "#c2255c", "#0c8599"];
const byId = (name) => document.getElementById(name);
const roadLines = DATA.roads.map((road) => ({
  surface: closed(road.surface),
  bands: road.bands.map(([around, raised]) => [closed(around), raised ? "raised" : "beside"]),
  covers: road.covers.map(([around, fill]) => ({ d: closed(around), fill })),
  paint: road.paint.map(closed).join(""),
  lines: road.lines.map(([line, broken]) => [ring(points(line)), broken]),
  points: points(road.surface),
}));

function points([x, y]) {
  const [east, north] = [undelta(x, 100), undelta(y, 100)];
  return east.map((value, index) => [value, -north[index]]);
}

function closed(around) {
  return ring(points(around)) + "Z";
}

// Where an agent drives, until it leaves.
function pathOf(agent) {
  return agent.x.slice(0, agent.until).map((x, index) => [x, agent.y[index]]);
}

function ring(line) {
  return "M" + line.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L");
}

class Viewer {
  constructor() {
    this.time = 0;
    this.playing = false;
    this.svg = byId("map");
    this.choice = byId("drive-choice");
    DATA.drives.forEach((drive, number) => {
      const words = [drive.label, drive.failed ? drive.worst : "holds", drive.place].filter(Boolean);
      this.choice.append(make("option", { value: number }, words.join(" \u00b7 ")));
    });
    this.choice.addEventListener("change", () => this.open(+this.choice.value));
    byId("drive-before").addEventListener("click", () => this.open(this.number - 1));
    byId("drive-after").addEventListener("click", () => this.open(this.number + 1));
    byId("play").addEventListener("click", () => this.play(!this.playing));
    byId("time").addEventListener("input", () => this.stopAt(+byId("time").value));
    byId("follow").addEventListener("change", () => this.show(this.time));
    byId("to-moment").addEventListener("click", () => this.stopAt(this.momentTime()));
    document.addEventListener("click", (event) => {
      const link = event.target.closest("[data-drive]");
      if (link) this.open(+link.dataset.drive);
    });
    window.addEventListener("resize", () => this.render());
    window.addEventListener("hashchange", () => this.openFromAddress());
    byId("drive").hidden = false;
    this.open(0);
    this.openFromAddress();
  }

  openFromAddress() {
    const found = /^#drive-(\d+)$/.exec(location.hash);
    if (!found || !DATA.drives[+found[1]]) return;
    this.open(+found[1]);
    byId("drive").scrollIntoView();
  }

  open(number) {
    this.play(false);
    this.number = (number + DATA.drives.length) % DATA.drives.length;
    const drive = (this.drive = DATA.drives[this.number]);
    this.choice.value = this.number;
    for (const link of document.querySelectorAll(".gallery a[aria-current]")) link.removeAttribute("aria-current");
    const link = document.querySelector(`.gallery a[data-drive="${this.number}"]`);
    if (link) link.setAttribute("aria-current", "true");
    this.times = undelta(drive.time, 1000);
    this.agents = drive.agents.map((agent, index) => ({
      name: agent.name,
      size: agent.size,
      color: COLORS[index % COLORS.length],
      x: undelta(agent.x, 100),
      y: undelta(agent.y, 100).map((value) => -value),
      heading: undelta(agent.heading, 1000),
      until: agent.until,
    }));
    byId("time").max = this.times.length ? this.times[this.times.length - 1] : 0;
    this.drawMap();
    this.describe();
    this.makePlots();
    this.show(drive.failed ? this.momentTime() : 0);
  }

  momentTime() {
    return this.drive.moment === null ? 0 : this.times[this.drive.moment];
  }

  drawMap() {
    const drive = this.drive;
    const roads = drive.roads.map((number) => roadLines[number]);
    const paths = this.agents.flatMap(pathOf);
    const around = roads.length > 3 && paths.length ? paths : paths.concat(...roads.map((road) => road.points));
    const [left, right] = limits(around.map(([x]) => x));
    const [top, bottom] = limits(around.map(([, y]) => y));
    const wide = Math.max(right - left, 20) + 10;
    const tall = Math.min(Math.max(bottom - top + 10, 0.35 * wide), 1.2 * wide);
    this.whole = [(left + right - wide) / 2, (top + bottom - Math.max(tall, bottom - top + 10)) / 2, wide, Math.max(tall, bottom - top + 10)];
    this.svg.style.aspectRatio = `${wide} / ${Math.max(tall, 1)}`;
    const parts = roads.map((road) => draw("path", { d: road.surface, class: "surface" }));
    for (const road of roads) {
      for (const [band, look] of road.bands) parts.push(draw("path", { d: band, class: look }));
      for (const cover of road.covers) parts.push(draw("path", cover));
      if (road.paint) parts.push(draw("path", { d: road.paint, class: "paint" }));
      for (const [line, broken] of road.lines) parts.push(draw("path", { d: line, class: broken ? "line broken" : "line" }));
    }
    parts.push(...drive.objects.map(thing));
    parts.push(...this.drawPaths());
    const agent = this.agents.find((found) => found.name === drive.agent);
    if (agent && drive.moment !== null && drive.failed) {
      const [x, y] = [agent.x[drive.moment], agent.y[drive.moment]];
      parts.push(draw("circle", { cx: x, cy: y, r: wide / 45, class: "moment" }, titled(`first goes wrong at ${drive.place}`)));
    }
    for (const found of this.agents) parts.push((found.node = car(found)));
    this.svg.replaceChildren(...parts);
  }

  drawPaths() {
    const width = Math.max(this.whole[2] / 260, 0.4);
    return this.agents.flatMap((agent) => {
      const line = pathOf(agent);
      if (agent.name !== this.drive.agent || !this.drive.shades.length) {
        return [draw("path", { d: ring(line), class: "drive-path", stroke: agent.color, "stroke-width": width / 2 })];
      }
      const parts = [];
      let first = 0;
      this.drive.shades.forEach((shade, index, all) => {
        if (shade === all[index + 1]) return;
        const part = line.slice(first, index + 2);
        if (part.length) parts.push(draw("path", { d: ring(part), class: "drive-path", stroke: DATA.shades[shade], "stroke-width": width }));
        first = index + 1;
      });
      return parts;
    });
  }

  describe() {
    const drive = this.drive;
    const line = byId("drive-verdict");
    line.replaceChildren();
    drive.verdicts.forEach((verdict, index) => {
      const word = verdict.satisfied === null ? "not judged" : verdict.satisfied ? "holds" : "violated";
      if (index) line.append(make("br"));
      line.append(make("span", { class: word.replace(" ", "-") }, word), ` ${verdict.name} `, make("code", {}, verdict.text));
      if (verdict.robustness !== null) line.append(`, robustness ${shown(verdict.robustness, verdict.unit)}`);
      if (verdict.name === drive.worst && drive.place) line.append(`, ${drive.failed ? "first violated" : "worst"} at ${drive.place}`);
    });
    for (const [agent, time, reason] of drive.controllerFailures) {
      const [first, ...rest] = reason.split("\n");
      line.append(make("br"), make("span", { class: "violated" }, "failed"), ` controller of ${agent} at ${time.toFixed(1)}\u00a0s: ${first}`);
      if (rest.length) line.append(make("pre", {}, rest.join("\n")));
    }
    const command = make("p", {}, "Drive it again: ", make("code", {}, `roadlang run ${drive.name}.json`));
    byId("drive-notes").replaceChildren(command, ...foundByCommands(drive));
  }

  makePlots() {
    const { drive, times } = this;
    const onTime = (time) => this.stopAt(time);
    this.plots = [];
    const driven = undelta(drive.driven, 100);
    const along = driven.length ? driven : undelta(drive.station, 100);
    const over = `\u2026 over ${driven.length ? "distance driven" : "arc length"}`;
    const isPlottable = (values) => values && times.length > 1 && values.some((value) => value !== null);
    for (const verdict of drive.verdicts) {
      if (!isPlottable(verdict.series)) continue;
      const { name, unit, series: values, text: note } = verdict;
      const same = { values, times, unit, zero: true, onTime };
      this.plots.push(new Plot({ ...same, title: `Robustness of ${name} over time`, note, across: times, acrossUnit: "s" }));
      if (along.length) {
        this.plots.push(new Plot({ ...same, title: `${over} of ${drive.agent}`, note: "", across: along, acrossUnit: "m" }));
      }
    }
    const speed = undelta(drive.speed, 100);
    if (isPlottable(speed)) {
      const same = { values: speed, times, unit: "m/s", zero: false, onTime };
      this.plots.push(new Plot({ ...same, title: `Speed of ${drive.agent} over time`, across: times, acrossUnit: "s" }));
      if (along.length) this.plots.push(new Plot({ ...same, title: over, across: along, acrossUnit: "m" }));
    }
    byId("plots").replaceChildren(...this.plots.map((plot) => plot.node));
    this.plots.forEach((plot) => plot.render());
  }

  render() {
    this.plots.forEach((plot) => plot.render());
    this.show(this.time);
  }

  show(time) {
    this.time = time;
    byId("time").value = time;
    byId("clock").textContent = `${time.toFixed(1)}\u00a0s`;
    for (const agent of this.agents) {
      const [x, y, heading] = [agent.x, agent.y, agent.heading].map((values) => valueAt(this.times, values, time));
      agent.node.style.display = agent.until < this.times.length && time >= this.times[agent.until] ? "none" : "";
      agent.node.setAttribute("transform", `translate(${x} ${y}) rotate(${(-heading * 180) / Math.PI})`);
    }
    this.frame(time);
    this.plots.forEach((plot) => plot.show(time));
  }

  frame(time) {
    const agent = this.agents.find((found) => found.name === this.drive.agent);
    let box = this.whole;
    if (byId("follow").checked && agent) {
      const wide = Math.min(70, this.whole[2]);
      const tall = (wide * this.whole[3]) / this.whole[2];
      const [x, y] = [agent.x, agent.y].map((values) => valueAt(this.times, values, time));
      box = [x - wide / 2, y - tall / 2, wide, tall];
    }
    this.svg.setAttribute("viewBox", box.map((value) => value.toFixed(2)).join(" "));
  }

  stopAt(time) {
    this.play(false);
    this.show(time);
  }

  play(on) {
    this.playing = on;
    byId("play").textContent = on ? "Pause" : "Play";
    byId("play").setAttribute("aria-pressed", on);
    if (!on) return;
    const end = this.times[this.times.length - 1];
    if (this.time >= end) this.show(0);
    let before = null;
    const step = (now) => {
      if (!this.playing) return;
      const passed = before === null ? 0 : ((now - before) / 1000) * +byId("rate").value;
      before = now;
      this.show(Math.min(this.time + passed, end));
      if (this.time >= end) this.play(false);
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}

function titled(words) {
  const node = draw("title");
  node.textContent = words;
  return node;
}

function thing([name, kind, x, y, heading, length, width]) {
  const turn = `translate(${x} ${-y}) rotate(${(-heading * 180) / Math.PI})`;
  if (kind === "tree" || kind === "bush") {
    return draw("circle", { r: Math.max(length, width) / 2, transform: turn, class: "leaves" }, titled(name));
  }
  const place = { x: -length / 2, y: -width / 2, width: length, height: width, transform: turn };
  return draw("rect", { ...place, class: kind === "building" ? "roof" : "thing" }, titled(name));
}

function car(agent) {
  const [length, width] = agent.size;
  const body = { x: -length / 2, y: -width / 2, width: length, height: width, rx: Math.min(length, width) / 5, fill: agent.color, class: "car" };
  const glass = { x: length * 0.1, y: -width * 0.38, width: length * 0.16, height: width * 0.76, class: "glass" };
  return draw("g", {}, draw("rect", body), draw("rect", glass), titled(agent.name));
}

// What `roadlang shrink` and `roadlang explain` found of the drive.
function foundByCommands({ name, shrunk, explanation }) {
  const parts = [];
  if (shrunk) {
    const rows = shrunk.draws.map(([draw, value, unit]) => [draw, typeof value === "number" ? shown(value, unit) : String(value)]);
    const count = `${shrunk.others} of ${shrunk.others + rows.length} random values are at their simplest; it needs:`;
    parts.push(make("h3", {}, "The simplest scene that still fails"), make("p", {}, count), list(rows));
    parts.push(make("p", {}, make("code", {}, `roadlang run ${name}.shrunk.json`)));
  }
  if (explanation) {
    const rows = explanation.medians.map(([draws, value, holds]) => [draws, ofMedian(value, holds, explanation.unit), holds ? "holds" : ""]);
    parts.push(make("h3", {}, "Which random values matter"));
    parts.push(make("p", {}, `Robustness of ${explanation.expectation} with these at their medians, the others as they are:`), list(rows));
    if (explanation.others) parts.push(make("p", {}, `${explanation.others} more have no effect by themselves.`));
  }
  return parts;
}

// The robustness with a draw at its median; `holds` is null where that is no scene.
function ofMedian(value, holds, unit) {
  if (holds === null) return "no scene";
  return value === null ? (holds ? "inf" : "-inf") : shown(value, unit);
}

function list(rows) {
  const lines = rows.map((cells) => make("tr", {}, ...cells.map((words, index) => make("td", { class: index === 1 ? "number" : words === "holds" ? "holds" : "" }, words))));
  return make("div", { class: "scroll" }, make("table", {}, make("tbody", {}, ...lines)));
}

const viewer = DATA.drives.length ? new Viewer() : null;

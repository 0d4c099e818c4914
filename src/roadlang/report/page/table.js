"use strict";
// The table of all drives: sorted, filtered, a part at a time. And the list of the page's parts.

const AT_ONCE = 50;
const MOST_ON_PAPER = 6;
const COMPARISON = /^\s*(.+?)\s*(<=|>=|<|>|=)\s*(-?[\d.]+(?:e-?\d+)?)\s*$/i;
const COMPARE = {
  "<": (a, b) => a < b,
  ">": (a, b) => a > b,
  "<=": (a, b) => a <= b,
  ">=": (a, b) => a >= b,
  "=": (a, b) => a === b,
};

class Table {
  constructor({ columns, rows, leftOut }) {
    Object.assign(this, { columns, rows, leftOut, sorted: null, ascending: true, limit: AT_ONCE });
    this.isNumber = columns.map((_, index) => rows.some(([values]) => typeof values[index] === "number"));
    let draws = 0; // on paper there is room for some
    this.classes = columns.map((column, index) => {
      const isExtra = column.draw ? ++draws > MOST_ON_PAPER : /^worst [xy]$|^random$/.test(column.name);
      return [this.isNumber[index] ? "number" : "", isExtra ? "extra" : ""].join(" ").trim();
    });
    this.head = document.querySelector("#table thead");
    this.body = document.querySelector("#table tbody");
    const cells = columns.map((column, index) => this.headCell(column, index));
    this.head.append(make("tr", {}, make("th", { scope: "col" }, this.button("outcome", -1)), ...cells));
    for (const name of ["filter", "outcome"]) {
      byId(name).addEventListener("input", () => {
        this.limit = AT_ONCE;
        this.show();
      });
    }
    byId("more").addEventListener("click", () => {
      this.limit += 4 * AT_ONCE;
      this.show();
    });
    byId("table").hidden = false;
    this.sortBy(-1, this.head.querySelector("th")); // what fails comes first
  }

  headCell(column, index) {
    const button = this.button(column.name, index);
    if (column.unit) button.append(" ", make("span", { class: "unit" }, column.unit));
    return make("th", { scope: "col", class: this.classes[index] }, button);
  }

  button(name, index) {
    const button = make("button", { type: "button" });
    name.split(/(?<=\/)/).forEach((part) => button.append(part, make("wbr")));
    button.addEventListener("click", () => this.sortBy(index, button.parentElement));
    return button;
  }

  sortBy(index, cell) {
    this.ascending = this.sorted === index ? !this.ascending : true;
    this.sorted = index;
    for (const other of this.head.querySelectorAll("th")) other.removeAttribute("aria-sort");
    cell.setAttribute("aria-sort", this.ascending ? "ascending" : "descending");
    this.show();
  }

  chosen() {
    const outcome = byId("outcome").value;
    const test = this.test(byId("filter").value);
    const rows = this.rows.filter(([values, failed]) => (outcome === "" || failed === +outcome) && test(values));
    if (this.sorted === null) return rows;
    const key = (row) => (this.sorted < 0 ? -row[1] : row[0][this.sorted]);
    const sign = this.ascending ? 1 : -1;
    return rows.sort((a, b) => order(key(a), key(b), sign));
  }

  test(words) {
    const found = COMPARISON.exec(words);
    if (found) {
      const name = found[1].toLowerCase();
      const names = this.columns.map((column) => column.name.toLowerCase());
      const index = names.includes(name) ? names.indexOf(name) : names.findIndex((other) => other.includes(name));
      if (index >= 0) {
        const limit = +found[3];
        return (values) => typeof values[index] === "number" && COMPARE[found[2]](values[index], limit);
      }
    }
    const wanted = words.trim().toLowerCase();
    return (values) => !wanted || values.some((value) => value !== null && String(value).toLowerCase().includes(wanted));
  }

  show() {
    const rows = this.chosen();
    this.body.replaceChildren(...rows.slice(0, this.limit).map((row) => this.row(row)));
    const left = this.leftOut ? ` ${this.leftOut.toLocaleString("en")} safe ones are only in the files.` : "";
    const count = Math.min(this.limit, rows.length);
    byId("table-count").textContent = `${count} of ${rows.length.toLocaleString("en")} drives.${left}`;
    byId("more").hidden = rows.length <= this.limit;
  }

  row([values, failed, drive]) {
    const word = failed ? "failing" : "safe";
    const first = drive === null ? word : make("a", { href: `#drive-${drive}`, "data-drive": drive }, word);
    const cells = values.map((value, index) => {
      const words = typeof value === "number" ? String(value).replace("-", "\u2212") : value === null || value === undefined ? "" : String(value);
      return make("td", { class: this.classes[index] }, words);
    });
    return make("tr", { class: failed ? "failed" : "safe" }, make("td", {}, first), ...cells);
  }
}

// What is missing comes last, whichever way the rest is sorted.
function order(a, b, sign) {
  const [noA, noB] = [a === null || a === undefined, b === null || b === undefined];
  if (noA || noB) return noA - noB;
  if (typeof a === "number" && typeof b === "number") return sign * (a - b);
  return sign * String(a).localeCompare(String(b), "en", { numeric: true });
}

const table = DATA.table.rows.length ? new Table(DATA.table) : null;

for (const section of document.querySelectorAll("main > section")) {
  if (section.hidden || !section.id) continue;
  document.querySelector("nav").append(make("a", { href: `#${section.id}` }, section.querySelector("h2").textContent));
}

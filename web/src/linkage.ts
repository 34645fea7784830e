// The equivalent linkage of every contact in the current row: its type, its lengths, and a sketch of it alone.
import { byId, element, svg } from "./dom";
import { quantity } from "./format";
import type { Numbers, Report, Rows, Shape } from "./model";
import type { Player } from "./player";
import { placeShape, shapeElement } from "./shapes";

const LENGTHS: readonly (readonly [string, string])[] = [
  ["r1", "frame"],
  ["r2", "first"],
  ["r3", "coupler"],
  ["r4", "second"],
  ["rho1", "curvature"],
  ["rho2", "curvature"],
];

export function addLinkages(
  report: Report,
  rows: Rows,
  columns: ReadonlyMap<string, number>,
  player: Player,
): void {
  byId("linkage-panel").hidden = report.contacts.length === 0;
  for (const contact of report.contacts) {
    const type = element("strong", { class: "type" });
    const lengths = element("dl");
    const show: ((row: number) => void)[] = [];
    for (const [name, meaning] of LENGTHS) {
      const k = columns.get(`${contact}.${name}`);
      const column = k === undefined ? undefined : report.columns[k];
      if (k === undefined || column === undefined || rows.values(k).every((value) => value === null)) continue;
      const value = element("dd");
      lengths.append(element("dt", {}, element("b", {}, name.replace("rho", "ρ")), ` ${meaning}`), value);
      show.push((row) => (value.textContent = quantity(rows.value(k, row), column.unit, column.noise)));
    }
    const word = columns.get(`${contact}.linkage`);
    const words = word === undefined ? [] : (report.columns[word]?.words ?? []);
    const sketch = new Sketch(report, rows, contact);
    player.onRow((row) => {
      const value = word === undefined ? null : rows.value(word, row);
      type.textContent = value === null ? "–" : (words[value] ?? "–");
      sketch.show(row);
    });
    player.onReadable((row) => show.forEach((update) => update(row)));
    const head = element("h3", {}, contact, " ", type);
    byId("linkages").append(element("article", { class: "linkage" }, element("div", {}, head, lengths), sketch.root));
  }
}

// The shapes of the linkage, in a separate picture that is large enough for all rows.
class Sketch {
  readonly root = svg("svg", { class: "sketch", "aria-hidden": "true" });
  private readonly parts: { shape: Shape; element: SVGElement; index: number }[] = [];

  constructor(
    private readonly report: Report,
    private readonly rows: Rows,
    contact: string,
  ) {
    report.scene.moving.forEach((shape, index) => {
      if (shape.role !== "linkage" || shape.name.split(".")[0] !== contact || shape.kind === "text") return;
      const part = shapeElement(shape);
      this.root.append(part);
      this.parts.push({ shape, element: part, index });
    });
    this.root.setAttribute("viewBox", this.room());
    this.root.style.setProperty("--unit", String(report.scene.unit));
    this.root.toggleAttribute("hidden", this.parts.length === 0);
  }

  show(row: number): void {
    const undefinedHere = this.rows.places(row) === null;
    this.root.classList.toggle("undefined", undefinedHere);
    if (undefinedHere) return;
    for (const { shape, element: part, index } of this.parts) {
      placeShape(part, shape, this.rows.shape(index, row), this.report.scene.unit);
    }
  }

  private room(): string {
    const [x0, y0, x1, y1] = this.report.scene.view;
    const middle = [(x0 + x1) / 2, (y0 + y1) / 2] as const;
    const reach = [x1 - x0, y1 - y0] as const; // limits the picture, for a centre of curvature may be far away
    const low = [Infinity, Infinity];
    const high = [-Infinity, -Infinity];
    for (let row = 0; row < this.rows.length; ++row) {
      for (const { shape, index } of this.parts) {
        points(shape, this.rows.shape(index, row)).forEach((point) =>
          point.forEach((value, i) => {
            const inside = Math.min(Math.max(value, (middle[i] ?? 0) - (reach[i] ?? 0)), (middle[i] ?? 0) + (reach[i] ?? 0));
            low[i] = Math.min(low[i] ?? 0, inside);
            high[i] = Math.max(high[i] ?? 0, inside);
          }),
        );
      }
    }
    const margin = 3 * this.report.scene.unit;
    const [left = 0, bottom = 0] = low;
    const [right = 0, top = 0] = high;
    return `${left - margin} ${-top - margin} ${right - left + 2 * margin} ${top - bottom + 2 * margin}`;
  }
}

function points(shape: Shape, numbers: Numbers): [number, number][] {
  const found: [number, number][] = [];
  const end = shape.kind === "circle" ? 2 : numbers.length;
  for (let i = 0; i + 1 < end; i += 2) {
    const [x, y] = [numbers[i] ?? null, numbers[i + 1] ?? null];
    if (x !== null && y !== null) found.push([x, y]);
  }
  return found;
}

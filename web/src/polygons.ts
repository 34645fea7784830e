// Figures below the mechanism for the current row: polygons of velocities, accelerations and forces, and the maps of contacts.
import { byId, element, svg } from "./dom";
import { number, quantity, unit } from "./format";
import { type Label, Labels } from "./labels";
import { addMaps } from "./maps";
import type { Polygon, Report, Rows, Vector } from "./model";
import type { Player } from "./player";
import { fillText, richText } from "./rich_text";
import { roundDown } from "./scales";
import { arrowHead } from "./shapes";

const WIDTH = 380; // of a picture; in px, as all lengths here
const TALLEST = 280;
const MARGIN = 34;
const FOOT = 26;
const HEAD = 10; // length of an arrow's head
const SHORTEST = 0.6; // shortest arrow that is drawn
const NAMED = 26; // shortest arrow that gets a name
const APART = 9; // between arrows that would cover each other
const BAR = 90;
const REFRESH = 45; // ms between two updates during the animation

/** A figure of the current row; during the animation it is updated only while visible. */
export interface Figure {
  readonly root: HTMLElement;
  show(row: number): void;
}

export function addFigures(report: Report, rows: Rows, player: Player): void {
  const polygons = report.polygons.map((polygon, i) => new PolygonFigure(polygon, i, rows));
  const figures: Figure[] = [...addMaps(report, rows), ...polygons];
  byId("figures-panel").hidden = figures.length === 0;
  byId("figures-head").textContent = report.maps.length > 0 ? "Contact map and polygons at the cursor" : "Polygons at the cursor";
  const seen = new Set<Element>();
  const observer = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting) seen.add(target);
      else seen.delete(target);
      if (isIntersecting) figures.find(({ root }) => root === target)?.show(player.row);
    }
  });
  for (const figure of figures) {
    byId("figures").append(figure.root);
    observer.observe(figure.root);
  }
  const showAll = (): void => figures.forEach((figure) => figure.show(player.row));
  let last = 0;
  player.onRow((row) => {
    if (player.playing && performance.now() - last < REFRESH) return;
    last = performance.now();
    for (const figure of figures) if (!player.playing || seen.has(figure.root)) figure.show(row);
  });
  player.onPlaying(showAll);
}

interface ArrowParts {
  readonly line: SVGElement;
  readonly head: SVGElement;
  readonly length: HTMLElement;
  readonly angle: HTMLElement;
  readonly entry: HTMLElement;
  readonly label: Label | null;
}

class PolygonFigure implements Figure {
  readonly root = element("figure", { class: "figure beside" });
  private readonly picture: SVGSVGElement;
  private readonly labels = new Labels();
  private readonly points: Label[];
  private readonly arrows: ArrowParts[];
  private readonly scale: number; // px per unit
  private readonly origin: Vector; // position of the pole
  private readonly noise: number;
  private readonly equations = element("div", { class: "equations" });
  private shownEquations: number | null = null;

  constructor(
    private readonly polygon: Polygon,
    private readonly index: number,
    private readonly rows: Rows,
  ) {
    const [x0, y0, x1, y1] = polygon.view;
    const size = Math.max(x1 - x0, y1 - y0) || 1;
    this.noise = 1e-5 * size;
    this.scale = Math.min((WIDTH - 2 * MARGIN) / Math.max(x1 - x0, 0.2 * size), TALLEST / Math.max(y1 - y0, 0.1 * size));
    const height = (y1 - y0) * this.scale + 2 * MARGIN + FOOT;
    this.origin = [WIDTH / 2 - (this.scale * (x0 + x1)) / 2, MARGIN + this.scale * y1];
    this.picture = svg("svg", { class: "polygon", viewBox: `0 0 ${WIDTH} ${height}`, "aria-hidden": "true", style: "--px: 1" });
    this.picture.append(...this.scaleBar(height - 10));
    const list = element("div", { class: "arrows" });
    this.arrows = polygon.arrows.map((arrow) => this.addArrow(arrow, list));
    const pole = polygon.pole === "" ? [] : [this.addName(polygon.pole)];
    this.points = [...pole, ...polygon.points.map(({ name }) => this.addName(name))];
    const shownUnit = unit(polygon.unit);
    const title = element("h3", {}, element("b", {}, polygon.title), shownUnit === "" ? "" : ` [${shownUnit}]`);
    this.root.append(title, this.picture, element("div", {}, list, this.equations));
  }

  show(row: number): void {
    this.polygon.arrows.forEach(({ from, to }, i) => {
      const parts = this.arrows[i];
      if (parts !== undefined) this.place(parts, i, this.vector(from, row), this.vector(to, row));
    });
    const places = [...(this.polygon.pole === "" ? [] : [[0, 0] as Vector]), ...this.polygon.points.map(({ at }) => this.vector(at, row))];
    const taken: Vector[] = [];
    places.forEach((place, i) => {
      const label = this.points[i];
      if (label === undefined) return;
      const [x, y] = place === null ? [0, 0] : this.pixels(place);
      const same = taken.some(([a, b]) => Math.hypot(a - x, b - y) < 2);
      if (!same) taken.push([x, y]);
      const [dx, dy] = place === null || (place[0] === 0 && place[1] === 0) ? [-0.6, -0.8] : place;
      this.put(label, place === null || same ? null : [x, y], [dx, dy]);
    });
    this.labels.place(() => [1, 0, 0, 0], 1);
    this.showEquations(this.rows.equations(this.index, row));
  }

  private showEquations(index: number | null): void {
    if (index === this.shownEquations) return;
    this.shownEquations = index;
    const texts = index === null ? [] : (this.polygon.equations[index] ?? []);
    this.equations.replaceChildren(...texts.map((text) => element("p", {}, richText(text))));
  }

  private vector(index: number, row: number): Vector | null {
    return this.rows.vector(this.index, index, row);
  }

  private pixels([x, y]: Vector): Vector {
    return [this.origin[0] + this.scale * x, this.origin[1] - this.scale * y];
  }

  // Labels take y upwards.
  private put(label: Label, at: Vector | null, direction: Vector): void {
    label.numbers = at === null ? [] : [at[0], -at[1], ...direction];
    label.element.classList.toggle("absent", at === null);
  }

  private place(parts: ArrowParts, i: number, from: Vector | null, to: Vector | null): void {
    const drawn = from !== null && to !== null;
    const [a, b] = drawn ? [this.pixels(from), this.pixels(to)] : [[0, 0] as Vector, [0, 0] as Vector];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const seen = drawn && length > SHORTEST;
    for (const part of [parts.line, parts.head]) part.classList.toggle("absent", !seen);
    parts.entry.classList.toggle("gone", !seen);
    parts.length.textContent = drawn ? number(Math.hypot(to[0] - from[0], to[1] - from[1]), this.noise, 4) : "–";
    parts.angle.textContent = seen ? quantity((Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI, "deg", 0.05, 4) : "";
    if (parts.label !== null) this.put(parts.label, null, [0, 0]);
    if (!seen) return;
    const across: Vector = [(b[1] - a[1]) / length, -(b[0] - a[0]) / length];
    // Always shifted to the same side, whichever way the arrow points.
    const side = this.polygon.flat ? (across[1] > 0 || (across[1] === 0 && across[0] > 0) ? 1 : -1) * APART * (i - (this.arrows.length - 1) / 2) : 0;
    const shift = ([x, y]: Vector): Vector => [x + side * across[0], y + side * across[1]];
    const [start, end] = [shift(a), shift(b)];
    const [tip, base] = arrowHead(start, end, Math.min(HEAD, 0.6 * length));
    parts.line.setAttribute("d", `M${start.join(" ")}L${base.join(" ")}`);
    parts.head.setAttribute("d", tip);
    if (parts.label !== null && length > NAMED) {
      this.put(parts.label, [(start[0] + end[0]) / 2, (start[1] + end[1]) / 2], [-across[0], across[1]]);
    }
  }

  private addArrow(arrow: Polygon["arrows"][number], list: HTMLElement): ArrowParts {
    const line = svg("path", { class: `v-${arrow.kind}`, "data-name": arrow.item });
    const head = svg("path", { class: `v-${arrow.kind} head` });
    this.picture.append(line, head);
    const swatch = svg("svg", { viewBox: "0 0 26 8", "aria-hidden": "true" });
    swatch.append(svg("path", { class: `v-${arrow.kind}`, d: "M1 4H25" }));
    const [length, angle] = [element("span", { class: "number" }), element("span", { class: "number" })];
    const entry = element("div", {}, swatch, richText(arrow.name), length, angle);
    list.append(entry);
    return { line, head, length, angle, entry, label: this.polygon.forces ? this.addName(arrow.name) : null };
  }

  private addName(name: string): Label {
    const text = svg("text", { class: "name" });
    fillText(text, name);
    this.picture.append(text);
    return this.labels.add(text, [], 0);
  }

  private scaleBar(y: number): SVGElement[] {
    const value = roundDown(BAR / this.scale);
    const end = 8 + value * this.scale;
    const text = svg("text", { x: String(end + 8), y: String(y), style: "text-anchor: start" });
    text.textContent = quantity(value, this.polygon.unit);
    return [svg("path", { d: `M8 ${y - 4}V${y + 4}M8 ${y}H${end}M${end} ${y - 4}V${y + 4}` }), text];
  }
}

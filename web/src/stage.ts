// The drawing of the mechanism: shapes that move with their bodies, and shapes whose numbers change from row to row.
import { byId, svg } from "./dom";
import { type Frame, type Label, Labels } from "./labels";
import type { Report, Rows, Shape } from "./model";
import { quantity } from "./format";
import { placeShape, shapeElement } from "./shapes";

export class Stage {
  readonly root = svg("svg", { id: "drawing", role: "img", tabindex: "0" });
  /** Groups of consecutive shapes of the same body. */
  private readonly groups: { readonly body: number; readonly element: SVGGElement }[] = [];
  private readonly labels = new Labels();
  /** Its texts give lengths of links that are broken off, and names. */
  private readonly moving: { readonly shape: Shape; readonly element: SVGElement; readonly label: Label | null }[];
  private row = 0;
  private scale = 1;

  constructor(
    private readonly report: Report,
    private readonly rows: Rows,
  ) {
    const fixed = svg("g", { class: "fixed" });
    const moving = svg("g", { class: "moving" });
    const labels = svg("g", { class: "labels" });
    this.root.append(fixed, moving, labels);
    this.root.setAttribute("aria-label", `${report.title}, drawing of the mechanism`);
    for (const shape of report.scene.fixed) this.addFixed(shape, fixed, labels);
    this.moving = report.scene.moving.map((shape) => {
      const element = shapeElement(shape);
      const isText = shape.kind === "text";
      (isText ? labels : moving).append(element);
      return { shape, element, label: isText ? this.labels.add(element, [], 0) : null };
    });
    const places = rows.places(0);
    if (places !== null) this.labels.dropSeconds((body) => frame(places, body), report.scene.unit);
    byId("stage").prepend(this.root);
  }

  private addFixed(shape: Report["scene"]["fixed"][number], fixed: SVGGElement, labels: SVGGElement): void {
    const element = shapeElement(shape);
    const body = shape.body ?? 0;
    if (shape.kind === "text") {
      labels.append(element);
      this.labels.add(element, shape.numbers, body);
      return;
    }
    placeShape(element, shape, shape.numbers, this.report.scene.unit);
    let group = this.groups[this.groups.length - 1];
    if (group === undefined || group.body !== body) {
      group = { body, element: svg("g", { "data-frame": String(body), class: `frame c${(body + 5) % 6}` }) };
      fixed.append(group.element);
      this.groups.push(group);
    }
    group.element.append(element);
  }

  /** @param scale  units per px; texts keep their size in px */
  setScale(scale: number): void {
    this.scale = scale;
    this.show(this.row);
  }

  show(row: number): void {
    this.row = row;
    const places = this.rows.places(row);
    this.root.classList.toggle("undefined", places === null);
    if (places === null) return;
    for (const { body, element } of this.groups) {
      const [c, s, x, y] = frame(places, body);
      element.setAttribute("transform", `matrix(${c} ${-s} ${s} ${c} ${x} ${-y})`);
    }
    this.moving.forEach(({ shape, element, label }, i) => {
      // Hidden shapes need not be placed, except contacts, whose positions are read back.
      if (shape.role !== "contact" && this.root.classList.contains(`hide-${shape.role}`)) return;
      const numbers = this.rows.shape(i, row);
      placeShape(element, shape, numbers, this.report.scene.unit);
      if (label !== null) this.labels.change(label, numbers, (shape.text ?? "") + this.lengthText(numbers[4]));
    });
    this.labels.place((body) => frame(places, body), this.scale);
  }

  // Behind the name of a link that is broken off.
  private lengthText(length: number | null | undefined): string {
    return length === null || length === undefined ? "" : " = " + quantity(length * this.report.lengthPerUnit, this.report.lengthUnit, 0, 4);
  }

  /** The drawn position of a point of a body [units], read back from the drawing; null if nothing of the body is drawn. */
  drawn(body: number, point: readonly [number, number]): [number, number] | null {
    if (this.root.classList.contains("undefined")) return null;
    if (body === 0) return [point[0], point[1]];
    const matrix = this.groups.find((group) => group.body === body)?.element.transform.baseVal.consolidate()?.matrix;
    if (matrix === undefined) return null;
    const [x, y] = [point[0], -point[1]];
    return [matrix.a * x + matrix.c * y + matrix.e, -(matrix.b * x + matrix.d * y + matrix.f)];
  }

  /** The same for a contact point. */
  drawnContact(name: string): [number, number] | null {
    if (this.root.classList.contains("undefined")) return null;
    const point = this.moving.find(
      ({ shape }) => shape.role === "contact" && shape.name === name && shape.kind === "circle",
    )?.element;
    if (point === undefined || point.classList.contains("absent")) return null;
    return [Number(point.getAttribute("cx")), -Number(point.getAttribute("cy"))];
  }
}

function frame(places: readonly number[], body: number): Frame {
  const theta = places[3 * body + 2] ?? 0;
  return [Math.cos(theta), Math.sin(theta), places[3 * body] ?? 0, places[3 * body + 1] ?? 0];
}

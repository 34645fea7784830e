// Names in the drawing, placed so that they cover neither each other nor the points they name.
import type { Numbers } from "./model";

const HEIGHT = 15; // of a text [px]
const CLEARANCE = 9; // of a text from its point [px]
const POINT = 5; // half the room of a point [px]

interface Rectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface Label {
  readonly element: SVGElement;
  /** Where, and the direction in which it keeps clear of that; empty: it is not shown. */
  numbers: Numbers;
  readonly body: number;
  width: number;
  /** Which of the candidates was taken last: it is tried first, so that names do not hop about. */
  last: number;
  /** Another label stands at the same place. */
  second: boolean;
}

/** From a body's frame to ground. */
export type Frame = readonly [cos: number, sin: number, x: number, y: number];

/** Directions that are tried, turned against the one that is wanted [rad]. */
const TURNS = [0, 0.8, -0.8, 1.6, -1.6, 2.4, -2.4, Math.PI];

export class Labels {
  private readonly labels: Label[] = [];
  private readonly pen = document.createElement("canvas").getContext("2d");

  add(element: SVGElement, numbers: Numbers, body: number): Label {
    const label = { element, numbers, body, width: this.widthOf(element.textContent ?? ""), last: 0, second: false };
    this.labels.push(label);
    return label;
  }

  /** Another place, or none, and another text. */
  change(label: Label, numbers: Numbers, text: string): void {
    label.numbers = numbers;
    if (numbers.length === 0 || text === label.element.textContent) return;
    label.element.textContent = text;
    label.width = this.widthOf(text);
  }

  private widthOf(text: string): number {
    if (this.pen !== null) this.pen.font = "13px system-ui, sans-serif";
    return this.pen?.measureText(text).width ?? 30;
  }

  /** Of several points at one place the first keeps its name. */
  dropSeconds(frame: (body: number) => Frame, near: number): void {
    const anchors = this.labels.map(({ numbers, body }) => anchorOf(numbers, frame(body)));
    this.labels.forEach((label, i) => {
      const here = anchors[i];
      if (here === undefined || (here.dx === 0 && here.dy === 0)) return;
      label.second = anchors.slice(0, i).some((other, k) => {
        const first = this.labels[k];
        return first?.second === false && Math.hypot(here.x - other.x, here.y - other.y) < near;
      });
      if (label.second) label.element.classList.add("absent");
    });
  }

  /** @param scale  mm per px */
  place(frame: (body: number) => Frame, scale: number): void {
    const shown = this.labels.filter(({ second, numbers }) => !second && numbers.length > 0);
    const anchors = shown.map(({ numbers, body }) => anchorOf(numbers, frame(body)));
    const taken: Rectangle[] = anchors
      .filter(({ dx, dy }) => dx !== 0 || dy !== 0)
      .map(({ x, y }) => ({ x: x / scale - POINT, y: -y / scale - POINT, width: 2 * POINT, height: 2 * POINT }));
    shown.forEach((label, i) => {
      const anchor = anchors[i];
      if (anchor !== undefined) this.placeOne(label, anchor, scale, taken);
    });
  }

  private placeOne(label: Label, anchor: Anchor, scale: number, taken: Rectangle[]): void {
    const candidates = candidatesOf(anchor, label.width, scale);
    const order = [label.last, ...candidates.keys()];
    const free = order.find((k) => {
      const candidate = candidates[k];
      return candidate !== undefined && !taken.some((other) => overlap(candidate, other));
    });
    label.element.classList.toggle("absent", free === undefined);
    const chosen = free === undefined ? undefined : candidates[free];
    if (free === undefined || chosen === undefined) return;
    label.last = free;
    taken.push(chosen);
    const [x, y] = [(chosen.x + chosen.width / 2) * scale, (chosen.y + chosen.height / 2) * scale];
    label.element.setAttribute("transform", `translate(${x.toFixed(3)} ${y.toFixed(3)})`); // x and y would lay the text out anew
  }
}

interface Anchor {
  readonly x: number;
  readonly y: number;
  readonly dx: number;
  readonly dy: number;
}

function anchorOf(numbers: Numbers, [c, s, x, y]: Frame): Anchor {
  const [px = 0, py = 0, dx = 0, dy = 0] = numbers as number[];
  return { x: x + c * px - s * py, y: y + s * px + c * py, dx: c * dx - s * dy, dy: s * dx + c * dy };
}

// Rectangles of the text in px, y down. A text without a direction stands on its place if it can.
function candidatesOf({ x, y, dx, dy }: Anchor, width: number, scale: number): Rectangle[] {
  const free = dx === 0 && dy === 0;
  const wanted = free ? Math.PI / 2 : Math.atan2(dy, dx);
  const at = (cx: number, cy: number): Rectangle => ({ x: cx - width / 2, y: cy - HEIGHT / 2, width, height: HEIGHT });
  const around = TURNS.map((turn) => {
    const [ux, uy] = [Math.cos(wanted + turn), Math.sin(wanted + turn)];
    return at(
      x / scale + CLEARANCE * ux + (width / 2) * Math.max(-1, Math.min(1, 1.6 * ux)),
      -y / scale - CLEARANCE * uy - (HEIGHT / 2) * Math.max(-1, Math.min(1, 1.6 * uy)),
    );
  });
  return free ? [at(x / scale, -y / scale), ...around] : around;
}

function overlap(a: Rectangle, b: Rectangle): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

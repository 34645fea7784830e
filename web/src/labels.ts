// Names in the drawing, placed so that they cover neither each other nor the points they name.
import type { Numbers } from "./model";

const HEIGHT = 15; // height of a text [px]
const CLEARANCE = 9; // distance of a text from its point [px]
const POINT = 5; // half the size of the area kept free around a point [px]

interface Rectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface Label {
  readonly element: SVGElement;
  /** Position, and direction in which the text is offset from it; empty: the label is not shown. */
  numbers: Numbers;
  readonly body: number;
  width: number;
  /** Index of the candidate chosen last; it is tried first, so that names do not jump. */
  last: number;
  /** Whether an earlier label is at the same position. */
  second: boolean;
}

/** Transformation from a body's frame to ground. */
export type Frame = readonly [cos: number, sin: number, x: number, y: number];

/** Directions tried, relative to the wanted one [rad]. */
const TURNS = [0, 0.8, -0.8, 1.6, -1.6, 2.4, -2.4, Math.PI];

export class Labels {
  private readonly labels: Label[] = [];
  private readonly pen = document.createElement("canvas").getContext("2d");

  add(element: SVGElement, numbers: Numbers, body: number): Label {
    const label = { element, numbers, body, width: this.widthOf(element.textContent ?? ""), last: 0, second: false };
    this.labels.push(label);
    return label;
  }

  /** Sets another position, or none, and another text. */
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

  /** Of several labels at one position only the first is shown. */
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

  /** @param scale  units per px */
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
    label.element.setAttribute("transform", `translate(${x.toFixed(3)} ${y.toFixed(3)})`); // setting x and y would make the browser lay out the text again
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

// Possible rectangles of the text in px, y down. Without a direction the first one is at the position itself.
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

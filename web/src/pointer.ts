// Pointers on the drawing: one on a body drags it with the mechanism, elsewhere it pans; two zoom.
import type { Report, Rows } from "./model";
import type { Player } from "./player";
import type { View } from "./view";

interface Grip {
  readonly body: number;
  /** Point where the body is held, in its frame [units]. */
  readonly point: readonly [number, number];
}

const REACH = { mouse: 4, touch: 14 } as const; // distance around a pointer in which bodies are found [px]
const ALIKE = 0.02; // relative to the picture: distances that differ by less are equally good

export class PointerControl {
  private readonly pointers = new Map<number, [number, number]>();
  private grip: Grip | null = null;

  constructor(
    private readonly root: SVGSVGElement,
    private readonly report: Report,
    private readonly rows: Rows,
    private readonly player: Player,
    private readonly view: View,
  ) {
    root.addEventListener("pointerdown", (event) => this.down(event));
    root.addEventListener("pointermove", (event) => this.move(event));
    for (const type of ["pointerup", "pointercancel"] as const) root.addEventListener(type, (event) => this.up(event));
    root.addEventListener("dblclick", (event) => this.view.zoom(1.6, [event.clientX, event.clientY]));
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.root.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    const body = this.bodyAt(event);
    this.grip = this.pointers.size === 1 && body !== null ? this.gripOf(body, event) : null;
    if (this.grip === null) return;
    this.player.pause();
    this.root.classList.add("dragging");
  }

  private move(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId);
    if (before === undefined) {
      this.root.classList.toggle("over-body", event.pointerType === "mouse" && this.bodyAt(event) !== null);
      return;
    }
    if (this.grip !== null) {
      this.player.go(this.nearestRow(this.grip, this.place(event)));
    } else if (this.pointers.size === 1) {
      this.view.pan(event.clientX - before[0], event.clientY - before[1]);
    } else {
      this.pinch(event, before);
    }
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  private up(event: PointerEvent): void {
    this.pointers.delete(event.pointerId);
    this.grip = null;
    this.root.classList.remove("dragging");
  }

  private pinch(event: PointerEvent, before: readonly [number, number]): void {
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (other === undefined) return;
    const now = Math.hypot(event.clientX - other[0], event.clientY - other[1]);
    const was = Math.hypot(before[0] - other[0], before[1] - other[1]);
    if (was > 0 && now > 0) this.view.zoom(now / was, other);
  }

  // The body under or near the pointer; the driven body has priority.
  private bodyAt(event: PointerEvent): number | null {
    const reach = event.pointerType === "mouse" ? REACH.mouse : REACH.touch;
    const around = [0, reach, -reach];
    const found = new Set<number>();
    for (const dx of around) {
      for (const dy of around) {
        for (const part of document.elementsFromPoint(event.clientX + dx, event.clientY + dy)) {
          const body = part.getAttribute("data-body");
          if (body !== null && body !== "0" && this.root.contains(part)) found.add(Number(body));
        }
      }
    }
    return found.has(this.report.driver.body) ? this.report.driver.body : (found.values().next().value ?? null);
  }

  // The pointer's position in ground [units], y up.
  private place(event: PointerEvent): [number, number] {
    const [x, y] = this.view.toDrawing([event.clientX, event.clientY]);
    return [x, -y];
  }

  private gripOf(body: number, event: PointerEvent): Grip | null {
    const places = this.rows.places(this.player.row);
    if (places === null) return null;
    const theta = places[3 * body + 2] ?? 0;
    const [x, y] = this.place(event);
    const [dx, dy] = [x - (places[3 * body] ?? 0), y - (places[3 * body + 1] ?? 0)];
    const [c, s] = [Math.cos(theta), Math.sin(theta)];
    return { body, point: [c * dx + s * dy, c * dy - s * dx] };
  }

  // The row in which the point held is nearest to the pointer; among several such rows, the one nearest to the
  // current row.
  private nearestRow(grip: Grip, at: readonly [number, number]): number {
    const off = Array.from({ length: this.rows.length }, (_, row) => this.distance(grip, at, row));
    const [x0, y0, x1, y1] = this.report.scene.view;
    const enough = Math.min(...off) + ALIKE * Math.hypot(x1 - x0, y1 - y0);
    let best = this.player.row;
    let least = Infinity;
    off.forEach((here, row) => {
      const isLowest = here <= (off[row - 1] ?? Infinity) && here <= (off[row + 1] ?? Infinity);
      if (!isLowest || here > enough || this.apart(row) >= least) return;
      [best, least] = [row, this.apart(row)];
    });
    return best;
  }

  // Distance of the point held from another position [units].
  private distance({ body, point }: Grip, [x, y]: readonly [number, number], row: number): number {
    const places = this.rows.places(row);
    if (places === null) return Infinity;
    const theta = places[3 * body + 2] ?? 0;
    const [c, s] = [Math.cos(theta), Math.sin(theta)];
    return Math.hypot(
      (places[3 * body] ?? 0) + c * point[0] - s * point[1] - x,
      (places[3 * body + 1] ?? 0) + s * point[0] + c * point[1] - y,
    );
  }

  private apart(row: number): number {
    const rows = Math.abs(row - this.player.row);
    return this.report.closed ? Math.min(rows, this.rows.length - 1 - rows) : rows;
  }
}

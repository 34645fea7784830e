// The visible part of the drawing: fit, zoom, pan.
import { byId } from "./dom";
import type { Report } from "./model";

const MARGIN = 0.06; // relative to the picture: margin around everything that moves
/** Factor per click of a button, or per key. */
export const ZOOM = 1.3;

export class View {
  /** units per px, and the centre of the picture [units, y down] */
  private scale = 1;
  private centre: [number, number] = [0, 0];
  private fitted = true;

  constructor(
    private readonly root: SVGSVGElement,
    private readonly report: Report,
    private readonly scaled: (unitsPerPixel: number) => void,
  ) {
    new ResizeObserver(() => (this.fitted ? this.fit() : this.apply())).observe(root);
    byId("zoom-in").addEventListener("click", () => this.zoom(ZOOM));
    byId("zoom-out").addEventListener("click", () => this.zoom(1 / ZOOM));
    byId("zoom-fit").addEventListener("click", () => this.fit());
    root.addEventListener(
      "wheel",
      (event) => {
        // The wheel without a modifier key scrolls the page.
        if (!event.ctrlKey && !event.metaKey && document.fullscreenElement === null) return;
        event.preventDefault();
        this.zoom(Math.exp(-event.deltaY / 300), [event.clientX, event.clientY]);
      },
      { passive: false },
    );
    this.fit();
  }

  fit(): void {
    const [x0, y0, x1, y1] = this.report.scene.view;
    const { clientWidth: width, clientHeight: height } = this.root;
    if (width === 0 || height === 0) return;
    const room = 1 - 2 * MARGIN;
    this.scale = Math.max((x1 - x0) / (room * width), (y1 - y0) / (room * height)) || 1;
    this.centre = [(x0 + x1) / 2, -(y0 + y1) / 2];
    this.fitted = true;
    this.apply();
  }

  /** @param at  point that stays in place [px of the window]; none: the centre */
  zoom(factor: number, at?: [number, number]): void {
    const before = at === undefined ? this.centre : this.toDrawing(at);
    this.scale /= factor;
    this.centre = [
      before[0] + (this.centre[0] - before[0]) / factor,
      before[1] + (this.centre[1] - before[1]) / factor,
    ];
    this.fitted = false;
    this.apply();
  }

  pan(dx: number, dy: number): void {
    this.centre = [this.centre[0] - dx * this.scale, this.centre[1] - dy * this.scale];
    this.fitted = false;
    this.apply();
  }

  /** Converts px of the window to units, y down. */
  toDrawing([x, y]: readonly [number, number]): [number, number] {
    const box = this.root.getBoundingClientRect();
    return [
      this.centre[0] + (x - box.left - box.width / 2) * this.scale,
      this.centre[1] + (y - box.top - box.height / 2) * this.scale,
    ];
  }

  private apply(): void {
    const { clientWidth: width, clientHeight: height } = this.root;
    const [w, h] = [width * this.scale, height * this.scale];
    const [x, y] = [this.centre[0] - w / 2, this.centre[1] - h / 2];
    this.root.setAttribute("viewBox", `${x} ${y} ${w} ${h}`);
    // For parts that keep their size in px, such as texts.
    this.root.style.setProperty("--px", String(this.scale));
    // Lets drawn positions be read back from a saved picture.
    this.root.setAttribute("data-scale", String(1 / this.scale / this.report.lengthPerUnit));
    this.root.setAttribute("data-origin", `${-x / this.scale} ${-y / this.scale}`);
    this.root.classList.toggle("zoomed", !this.fitted);
    this.scaled(this.scale);
  }
}

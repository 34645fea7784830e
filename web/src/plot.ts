// One plot: columns over an axis, with events and rows that are not ok, and a cursor that moves the mechanism.
import uPlot from "uplot";
import { colour, element } from "./dom";
import { quantity, tickLabels, unit } from "./format";
import type { Column, Rows } from "./model";

/** Colours that colour-blind people can distinguish, and dashes for black and white print. */
const SERIES = ["--series-1", "--series-2", "--series-3", "--series-4", "--series-5", "--series-6"] as const;
const DASHES: readonly number[][] = [[], [7, 4], [2, 3], [9, 3, 2, 3], [14, 4], [4, 4]];
const HEIGHT = 170; // px
const FONT = "12px system-ui, sans-serif";
const LEAST_LABEL_ROOM = 62; // px: the same for most plots, so that they are in line
const LABEL_GAP = 9; // px
const NEAR_ZERO = 0.25; // an axis so close to 0, in lengths of its range, is extended to it beside another one that has it
const UNIT_ROOM = 15; // px: for the unit beside an axis, within the room for labels
/** Steps of ticks; of degrees they divide a turn where there is room. */
const DECADES = Array.from({ length: 40 }, (_, i) => 10 ** (i - 20));
const DEGREES = [
  ...DECADES.filter((power) => power < 10).flatMap((power) => [power, 2 * power, 5 * power]),
  10, 15, 30, 45, 90, 180,
  ...DECADES.filter((power) => power >= 1).flatMap((power) => [360 * power, 720 * power, 1800 * power]),
];

/** The axis common to all plots of a page. */
export interface Axis {
  readonly name: string;
  readonly unit: string;
  /** In ascending order, with their rows in `rows`. */
  readonly values: readonly number[];
  readonly rows: readonly number[];
  readonly marks: readonly number[];
  /** Stretches of rows that are not ok. */
  readonly bad: readonly (readonly [number, number])[];
}

export interface PlotContext {
  readonly columns: readonly Column[];
  readonly rows: Rows;
  readonly go: (row: number) => void;
}

export class Plot {
  readonly element = element("figure", { class: "plot" });
  private readonly head = element("figcaption");
  private readonly canvas = element("div", { class: "canvas", "aria-hidden": "true" });
  private readonly line = element("div", { class: "cursor-line" });
  private chart: uPlot | null = null;
  private chips: HTMLElement[] = [];
  private row = 0;

  constructor(
    private shown: number[],
    private axis: Axis,
    private readonly context: PlotContext,
    private readonly emptied: (plot: Plot) => void,
  ) {
    this.element.append(this.head, this.canvas);
    new ResizeObserver(() => this.resize()).observe(this.canvas);
  }

  get shownColumns(): readonly number[] {
    return this.shown;
  }

  toggle(column: number): void {
    this.shown = this.shown.includes(column) ? this.shown.filter((k) => k !== column) : [...this.shown, column];
    if (this.shown.length === 0) this.emptied(this);
    else this.rebuild();
  }

  setAxis(axis: Axis): void {
    this.axis = axis;
    this.rebuild();
  }

  /** Draws the plot again, with other columns, another axis or other colours. */
  rebuild(): void {
    this.chart?.destroy();
    this.head.replaceChildren();
    this.chips = this.shown.map((k, i) => this.chip(k, i));
    this.chart = new uPlot(this.options(), this.data(), this.canvas);
    this.chart.over.append(this.line);
    this.listen(this.chart.over);
    this.showValues(); // the cursor is placed when the chart is drawn: it has no scales before
  }

  // Between two rows that a column does not join there is a point at which that column has no value, and the others none either but go on.
  private data(): uPlot.AlignedData {
    const { values, rows } = this.axis;
    const xs: number[] = [];
    const ys: (number | null | undefined)[][] = this.shown.map(() => []);
    rows.forEach((row, i) => {
      const [before, x] = [rows[i - 1] ?? row, values[i] ?? 0];
      const broken = this.shown.map((k) => this.context.columns[k]?.breaks?.includes(Math.max(before, row)) === true && before !== row);
      if (broken.includes(true)) {
        xs.push(((values[i - 1] ?? x) + x) / 2);
        ys.forEach((column, k) => column.push(broken[k] === true ? null : undefined));
      }
      xs.push(x);
      ys.forEach((column, k) => column.push(this.context.rows.value(this.shown[k] ?? 0, row)));
    });
    return [xs, ...ys];
  }

  show(row: number): void {
    this.moveTo(row);
    this.showValues();
  }

  /** Moves the cursor. */
  moveTo(row: number): void {
    this.row = row;
    const at = this.axis.rows.indexOf(row);
    const x = at < 0 ? undefined : this.axis.values[at];
    if (this.chart !== null && x !== undefined) {
      this.line.style.transform = `translateX(${this.chart.valToPos(x, "x")}px)`;
    }
  }

  /** Shows the numbers at the cursor. */
  showValues(): void {
    this.shown.forEach((k, i) => {
      const chip = this.chips[i];
      const column = this.context.columns[k];
      if (chip !== undefined && column !== undefined) {
        chip.textContent = quantity(this.context.rows.value(k, this.row), column.unit, column.noise);
      }
    });
  }

  private chip(k: number, i: number): HTMLElement {
    const column = this.context.columns[k];
    const value = element("span", { class: "now" });
    const remove = element("button", { type: "button", class: "remove", "aria-label": `Remove ${column?.name ?? ""}` }, "×");
    remove.addEventListener("click", () => this.toggle(k));
    const swatch = element("i", { class: `swatch s${(i % SERIES.length) + 1}` });
    this.head.append(element("span", { class: "chip" }, swatch, element("b", {}, column?.name ?? ""), value, remove));
    return value;
  }

  private options(): uPlot.Options {
    const units = [...new Set(this.shown.map((k) => this.context.columns[k]?.unit ?? ""))];
    const axis = { stroke: colour("--muted"), grid: { stroke: colour("--line"), width: 1 }, ticks: { show: false }, font: FONT };
    const values = (_: uPlot, ticks: number[], __: number, ___: number, step: number): string[] => tickLabels(ticks, step);
    const scales: Record<string, uPlot.Scale> = { x: { time: false } };
    const ranges = withCommonZero(units.map((name) => this.rangeOf(name)));
    units.forEach((name, i) => (scales[`y${name}`] = { range: () => ranges[i] ?? [0, 1] }));
    this.canvas.dataset["ranges"] = JSON.stringify(ranges); // for tests: the chart is a bitmap
    return {
      width: this.canvas.clientWidth || 400,
      height: HEIGHT,
      legend: { show: false },
      cursor: { show: false },
      scales,
      axes: [
        { ...axis, size: 28, space: 60, values, ...stepsOf(this.axis.unit) },
        ...units.slice(0, 2).map((name, i) => ({
          ...axis,
          scale: `y${name}`,
          side: i === 0 ? 3 : 1,
          size: (chart: uPlot, labels: readonly string[] | null) => labelRoom(chart, labels, LEAST_LABEL_ROOM),
          ...(i === 0 ? {} : { grid: { show: false } }),
          ...(units.length > 1 ? this.key(name) : {}),
          ...stepsOf(name),
          values,
        })),
      ],
      series: [
        {},
        ...this.shown.map((k, i) => ({
          scale: `y${this.context.columns[k]?.unit ?? ""}`,
          stroke: colour(SERIES[i % SERIES.length] ?? SERIES[0]),
          width: 2,
          dash: DASHES[i % DASHES.length] ?? [],
          points: { show: false },
          paths: lines,
          pxAlign: 0, // otherwise flat curves look like stairs
        })),
      ],
      hooks: { drawClear: [(chart) => this.drawBad(chart)], draw: [(chart) => this.drawMarks(chart), () => this.moveTo(this.row)] },
    };
  }

  // Of two axes each has its unit beside it, and the colour of its first line.
  private key(unitText: string): Partial<uPlot.Axis> {
    const first = this.shown.findIndex((k) => this.context.columns[k]?.unit === unitText);
    return {
      label: unit(unitText),
      labelFont: FONT,
      labelSize: UNIT_ROOM,
      stroke: colour(SERIES[first % SERIES.length] ?? SERIES[0]),
      size: (chart, labels) => labelRoom(chart, labels, LEAST_LABEL_ROOM - UNIT_ROOM),
    };
  }

  // Of the values of all columns of a unit that are plotted.
  private rangeOf(unitText: string): Range {
    let [low, high]: [number | null, number | null] = [null, null];
    for (const k of this.shown.filter((one) => this.context.columns[one]?.unit === unitText)) {
      for (const row of this.axis.rows) {
        const value = this.context.rows.value(k, row);
        if (value === null) continue;
        low = Math.min(low ?? value, value);
        high = Math.max(high ?? value, value);
      }
    }
    return range(low, high, this.noiseOf(unitText));
  }

  private noiseOf(unitText: string): number {
    return this.shown.reduce((most, k) => {
      const column = this.context.columns[k];
      return column?.unit === unitText ? Math.max(most, column.noise) : most;
    }, 0);
  }

  private drawBad(chart: uPlot): void {
    const { ctx, bbox } = chart;
    ctx.save();
    ctx.fillStyle = colour("--bad");
    for (const [from, to] of this.axis.bad) {
      const x = chart.valToPos(from, "x", true);
      ctx.fillRect(x, bbox.top, Math.max(chart.valToPos(to, "x", true) - x, 2), bbox.height);
    }
    ctx.restore();
  }

  private drawMarks(chart: uPlot): void {
    const { ctx, bbox } = chart;
    ctx.save();
    ctx.strokeStyle = colour("--event");
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([3 * devicePixelRatio, 3 * devicePixelRatio]);
    for (const mark of this.axis.marks) {
      const x = chart.valToPos(mark, "x", true);
      if (x < bbox.left - 1 || x > bbox.left + bbox.width + 1) continue;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
    }
    ctx.restore();
  }

  private listen(over: HTMLElement): void {
    const scrub = (event: PointerEvent): void => {
      if (this.chart === null) return;
      const x = this.chart.posToVal(event.clientX - over.getBoundingClientRect().left, "x");
      this.context.go(this.axis.rows[nearest(this.axis.values, x)] ?? 0);
    };
    over.addEventListener("pointerdown", (event) => {
      over.setPointerCapture(event.pointerId);
      scrub(event);
    });
    over.addEventListener("pointermove", (event) => {
      if (event.buttons !== 0) scrub(event);
    });
  }

  private resize(): void {
    const width = this.canvas.clientWidth;
    if (width === 0 || this.chart === null || this.chart.width === width) return;
    this.chart.setSize({ width, height: HEIGHT });
  }
}

// Lines from point to point, interrupted at null; a point that is joined to no other is a dot. uPlot's own lines are only hidden in gaps, which
// shows if a gap is narrower than the line.
const lines: uPlot.Series.PathBuilder = (chart, index, first, last) => {
  const stroke = new Path2D();
  const values = chart.data[index] ?? [];
  const scale = chart.series[index]?.scale ?? "";
  let joined = false;
  for (let i = first; i <= last; ++i) {
    const value = values[i];
    if (value === undefined) continue;
    if (value !== null) {
      const [x, y] = [chart.valToPos(chart.data[0][i] ?? 0, "x", true), chart.valToPos(value, scale, true)];
      if (joined) stroke.lineTo(x, y);
      else if (values.slice(i + 1).find((next) => next !== undefined) == null) stroke.arc(x, y, devicePixelRatio, 0, 2 * Math.PI);
      else stroke.moveTo(x, y);
    }
    joined = value !== null;
  }
  return { stroke };
};

function stepsOf(unitText: string): { incrs?: number[] } {
  return unitText === "deg" ? { incrs: DEGREES } : {};
}

// Room for the longest label beside a plot, in px.
function labelRoom(chart: uPlot, labels: readonly string[] | null, least: number): number {
  const { ctx } = chart;
  ctx.save();
  ctx.font = FONT;
  const widths = (labels ?? []).map((label) => ctx.measureText(label).width);
  ctx.restore();
  return Math.max(least, Math.ceil(Math.max(0, ...widths)) + LABEL_GAP);
}

// A constant column gets some room around it instead of a magnified rounding error.
type Range = [low: number, high: number];

// The ranges of two axes on which 0 is at the same height, if both contain it or nearly do. Each of them is at most twice as long as it was: its share
// below 0 becomes that which stretches both equally.
function withCommonZero(ranges: Range[]): Range[] {
  if (ranges.length !== 2 || !ranges.every(([low, high]) => Math.max(low, -high) <= NEAR_ZERO * (high - low))) return ranges;
  const ends = ranges.map(([low, high]): Range => [Math.min(low, 0), Math.max(high, 0)]);
  const shares = ends.map(([low, high]) => -low / (high - low));
  const [least, most] = [Math.min(...shares), Math.max(...shares)];
  const share = most / (1 - least + most);
  return ends.map(([low, high]) => {
    const length = Math.max(share > 0 ? -low / share : 0, share < 1 ? high / (1 - share) : 0);
    return [-share * length, (1 - share) * length];
  });
}

function range(low: number | null, high: number | null, noise: number): Range {
  if (low === null || high === null) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (high - low > Math.max(noise, 1e-9 * size)) return [low - 0.06 * (high - low), high + 0.06 * (high - low)];
  const room = size > noise ? 0.1 * size : 1;
  return [low - room, high + room];
}

/** Index of the value nearest to x; values in ascending order. */
export function nearest(values: readonly number[], x: number): number {
  let [low, high] = [0, values.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((values[middle] ?? 0) <= x) low = middle;
    else high = middle;
  }
  return Math.abs((values[low] ?? 0) - x) <= Math.abs((values[high] ?? 0) - x) ? low : high;
}

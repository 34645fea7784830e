// The scales of lengths and arrows in the drawing: a sample of each, with the length of a round number.
import { byId, element, svg } from "./dom";
import { quantity } from "./format";
import type { Report } from "./model";
import { arrowData } from "./shapes";

const LONGEST = 76; // px
const RADIUS = 6; // of the arc of a torque [px]
const MOST_TURN = 1.5 * Math.PI;

export class ScaleLegend {
  constructor(private readonly report: Report) {}

  /** @param scale  units per px */
  show(scale: number): void {
    const { scales } = this.report.scene;
    const samples = [sample("length", this.report.lengthUnit, 1 / this.report.lengthPerUnit / scale)];
    for (const [role, { unit, length, turn }] of Object.entries(scales)) {
      if (length !== undefined) samples.push(sample(role, unit, length / scale));
      if (turn !== undefined) samples.push(arcSample(unit, turn));
    }
    byId("scales").replaceChildren(...samples);
  }
}

function sample(role: string, unit: string, pixels: number): HTMLElement {
  const value = roundDown(LONGEST / pixels);
  const end = value * pixels;
  const bar = `M1 4V12M1 8H${1 + end}M${1 + end} 4V12`;
  const data = role === "length" ? bar : arrowData([1, -8, 1 + end, -8], 3.4);
  return entry(role, data, end + 2, quantity(value, unit));
}

function arcSample(unit: string, turn: number): HTMLElement {
  const value = roundDown(MOST_TURN / turn);
  const angle = Math.PI / 2 + value * turn;
  const [x, y] = [8 + RADIUS * Math.cos(angle), 8 - RADIUS * Math.sin(angle)];
  const large = value * turn > Math.PI ? 1 : 0;
  return entry("force", `M8 ${8 - RADIUS}A${RADIUS} ${RADIUS} 0 ${large} 0 ${x} ${y}`, 16, quantity(value, unit));
}

function entry(role: string, data: string, width: number, text: string): HTMLElement {
  const picture = svg("svg", { viewBox: `0 0 ${width} 16`, width: String(width) });
  picture.append(svg("path", { d: data, "data-role": role, class: data.includes("Z") ? "arrow" : "path" }));
  return element("span", { "data-role": role }, picture, text);
}

/** The largest of the numbers 1, 2 or 5 times a power of ten that do not exceed the value. */
export function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const digit = value / power;
  return Number(((digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power).toPrecision(1));
}

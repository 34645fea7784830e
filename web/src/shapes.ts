// Shapes of a scene as SVG elements. User units are those of the scene; y points down in SVG and up in the scene.
import { svg } from "./dom";
import type { Numbers, Shape, Vector } from "./model";

const HEAD_LENGTH = 2.6; // of an arrow, in the length unit of symbols
const HEAD_WIDTH = 0.9; // half the width

const digits = (value: number): string => String(Number(value.toFixed(4)));

function pathData(numbers: Numbers, closed: boolean): string {
  let data = "";
  let pen = "M";
  for (let i = 0; i + 1 < numbers.length; i += 2) {
    const x = numbers[i] ?? null;
    const y = numbers[i + 1] ?? null;
    if (x === null || y === null) {
      if (closed && pen === "L") data += "Z";
      pen = "M";
      continue;
    }
    data += `${pen}${digits(x)} ${digits(-y)}`;
    pen = "L";
  }
  return closed && data !== "" ? data + "Z" : data;
}

export function arrowData(numbers: Numbers, unit: number): string {
  const [x0, y0, x1, y1] = numbers as number[];
  if (x0 === undefined || y0 === undefined || x1 === undefined || y1 === undefined) return "";
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 0.2 * unit) return "";
  const head = Math.min(HEAD_LENGTH * unit, length / 2);
  const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
  const [bx, by] = [x1 - head * ux, y1 - head * uy];
  const half = (HEAD_WIDTH * head) / HEAD_LENGTH;
  const tip = [x1, y1, bx - half * uy, by + half * ux, bx + half * uy, by - half * ux];
  return `${pathData([x0, y0, bx, by], false)}${pathData(tip, true)}`;
}

/** Path data of an arrow's head, and the point where its line ends; y is not flipped. */
export function arrowHead([x0, y0]: Vector, [x1, y1]: Vector, head: number): [string, Vector] {
  const length = Math.hypot(x1 - x0, y1 - y0);
  const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
  const [bx, by] = [x1 - head * ux, y1 - head * uy];
  const half = 0.32 * head;
  const corners = [[x1, y1], [bx - half * uy, by + half * ux], [bx + half * uy, by - half * ux]];
  return [`M${corners.map(([x = 0, y = 0]) => `${digits(x)} ${digits(y)}`).join("L")}Z`, [bx, by]];
}

function titleOf(text: string): SVGElement {
  const title = svg("title");
  title.textContent = text;
  return title;
}

/** Makes an element for a shape, without coordinates yet. */
export function shapeElement(shape: Shape): SVGElement {
  const tag = shape.kind === "circle" ? "circle" : shape.kind === "text" ? "text" : "path";
  const made = svg(tag, { "data-role": shape.role, "data-name": shape.name, class: shape.kind });
  if (shape.body !== undefined) made.setAttribute("data-body", String(shape.body));
  if (shape.closed === true) made.classList.add("closed");
  if (shape.outline === true) made.classList.add("outline");
  if (shape.colour !== undefined) {
    const filled = shape.closed === true && shape.outline !== true;
    made.style.setProperty(filled ? "fill" : "stroke", shape.colour);
    made.classList.toggle("coloured", filled);
  }
  if (shape.kind === "text") made.textContent = shape.text ?? shape.name;
  else if (shape.text !== undefined) made.append(titleOf(shape.text));
  return made;
}

/** Sets the coordinates of a shape's element; hides it if there are none. */
export function placeShape(made: SVGElement, shape: Shape, numbers: Numbers, unit: number): void {
  const visible = numbers.length > 0;
  made.classList.toggle("absent", !visible);
  if (!visible) return;
  switch (shape.kind) {
    case "path":
      made.setAttribute("d", pathData(numbers, shape.closed === true));
      break;
    case "arrow":
      made.setAttribute("d", arrowData(numbers, unit));
      break;
    case "circle":
      made.setAttribute("cx", String(numbers[0]));
      made.setAttribute("cy", String(-(numbers[1] ?? 0)));
      made.setAttribute("r", String(numbers[2]));
      break;
    case "text": // placed by labels.ts
      break;
  }
}

// Names with `_{…}` for subscripts and `^{…}` for superscripts.
import { element, svg } from "./dom";

interface Piece {
  readonly text: string;
  readonly level: -1 | 0 | 1;
}

function pieces(text: string): Piece[] {
  return [...text.matchAll(/([_^])\{([^}]*)\}|[^_^]+|[_^]/g)].map(([all, sign, inner]) =>
    sign === undefined ? { text: all, level: 0 } : { text: inner ?? "", level: sign === "_" ? -1 : 1 },
  );
}

export function richText(text: string): HTMLElement {
  const parts = pieces(text).map(({ text: part, level }) => (level === 0 ? part : element(level < 0 ? "sub" : "sup", {}, part)));
  return element("span", {}, ...parts);
}

/** Puts the name into a text element of a drawing. */
export function fillText(made: SVGElement, text: string): void {
  let height = 0; // current vertical offset, downwards
  for (const { text: part, level } of pieces(text)) {
    const to = -4 * level;
    const piece = svg("tspan", { dy: String(to - height), ...(level === 0 ? {} : { "font-size": "10px" }) });
    piece.textContent = part;
    made.append(piece);
    height = to;
  }
}

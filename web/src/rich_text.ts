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

// A prime of the size of a subscript would be a dot on the screen.
const PRIME = /(′)/;
const PRIME_SIZE = 16; // px
const PRIME_LOWERED = 2; // px
const PRIME_APART = 1.5; // px: from its letter, which the halo would cover

export function richText(text: string): HTMLElement {
  const parts = pieces(text).map(({ text: part, level }) => {
    const shown = part.split(PRIME).map((piece) => (piece === "′" ? element("span", { class: "prime" }, piece) : piece));
    return level === 0 ? element("span", {}, ...shown) : element(level < 0 ? "sub" : "sup", {}, ...shown);
  });
  return element("span", {}, ...parts);
}

/** Puts the name into a text element of a drawing. */
export function fillText(made: SVGElement, markup: string): void {
  let height = 0; // current vertical offset, downwards
  for (const { text: part, level } of pieces(markup)) {
    for (const text of part.split(PRIME).filter((piece) => piece !== "")) {
      const prime = text === "′";
      const to = -4 * level + (prime ? PRIME_LOWERED : 0);
      const size = prime ? PRIME_SIZE : level === 0 ? null : 10;
      const piece = svg("tspan", { dy: String(to - height), ...(prime ? { dx: String(PRIME_APART) } : {}), ...(size === null ? {} : { "font-size": `${size}px` }) });
      piece.textContent = text;
      made.append(piece);
      height = to;
    }
  }
}

// Saves the current frame as SVG and the table as CSV.
import { byId, element } from "./dom";
import type { Report, Rows } from "./model";
import type { Player } from "./player";

const STYLES = [
  "fill", "fill-opacity", "fill-rule", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "stroke-linejoin",
  "vector-effect", "opacity", "font-family", "font-size", "font-weight", "paint-order", "text-anchor", "dominant-baseline",
] as const;

export function addSaving(report: Report, rows: Rows, player: Player, drawing: SVGSVGElement): void {
  const name = report.file.replace(/^.*[/\\]/, "").replace(/\.toml$/, "") || "motion";
  byId("save-svg").addEventListener("click", () =>
    download(`${name}-${player.row}.svg`, "image/svg+xml", pictureOf(drawing, report.title)),
  );
  byId("save-csv").addEventListener("click", () => download(`${name}.csv`, "text/csv", csvOf(report, rows)));
}

/** The drawing as a separate file, reduced to what is visible, with its styles. */
function pictureOf(drawing: SVGSVGElement, title: string): string {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  const originals = [drawing, ...drawing.querySelectorAll<SVGElement>("*")];
  const copies = [copy, ...copy.querySelectorAll<SVGElement>("*")];
  originals.forEach((original, i) => {
    const made = copies[i];
    if (made === undefined) return;
    const style = getComputedStyle(original);
    if (style.display === "none") {
      made.remove();
      return;
    }
    if (original instanceof SVGGElement || original === drawing) return;
    made.setAttribute("style", STYLES.map((key) => `${key}:${style.getPropertyValue(key)}`).join(";"));
  });
  copy.removeAttribute("style");
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(drawing.clientWidth));
  copy.setAttribute("height", String(drawing.clientHeight));
  const heading = document.createElementNS("http://www.w3.org/2000/svg", "title");
  heading.textContent = title;
  copy.prepend(heading);
  return new XMLSerializer().serializeToString(copy);
}

function csvOf(report: Report, rows: Rows): string {
  const head = report.columns.map(({ name, unit, words }) => (words === undefined ? `${name}[${unit}]` : name));
  const lines = [head.join(",")];
  for (let row = 0; row < rows.length; ++row) {
    const fields = report.columns.map(({ words }, k) => {
      const value = rows.value(k, row);
      return value === null ? "" : words === undefined ? String(value) : (words[value] ?? "");
    });
    lines.push(fields.join(","));
  }
  return lines.join("\n") + "\n";
}

function download(name: string, type: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

// Shows the configuration space of each contact, as drawn by the program, with the position of the current row.
import { element } from "./dom";
import type { Report, Rows } from "./model";
import type { Figure } from "./polygons";

/** Maps a coordinate to px of the picture. */
type Axis = (value: number) => number;

export function addMaps(report: Report, rows: Rows): Figure[] {
  return report.maps.map(({ contact, picture }, i) => {
    const drawn = new DOMParser().parseFromString(picture, "image/svg+xml").documentElement;
    const [x, y] = axesOf(drawn);
    const [width, height] = [Number(drawn.getAttribute("width")), Number(drawn.getAttribute("height"))];
    const image = element("img", { alt: `Branches of contact ${contact}`, src: `data:image/svg+xml,${encodeURIComponent(picture)}` });
    const point = element("i");
    const branch = element("span");
    const map = element("div", { class: "map" }, image, point);
    const root = element("figure", { class: "figure" }, element("h3", {}, element("b", {}, `Map of contact ${contact}`), " ", branch), map);
    const show = (row: number): void => {
      const place = rows.place(i, row);
      point.hidden = place === null;
      branch.textContent = place === null ? "" : `on branch ${place.branch}`;
      if (place === null) return;
      point.style.left = `${(100 * x(place.x)) / width}%`;
      point.style.top = `${(100 * y(place.y)) / height}%`;
    };
    return { root, show };
  });
}

function axesOf(picture: Element): [Axis, Axis] {
  const axes = [...picture.querySelectorAll("[data-domain]")].map((axis) => {
    const [low = 0, high = 1] = pair(axis, "data-domain");
    const [from = 0, to = 1] = pair(axis, "data-range");
    return { name: axis.getAttribute("data-name"), at: (value: number) => from + ((value - low) / (high - low)) * (to - from), down: from > to };
  });
  const none: Axis = () => 0;
  return [axes.find(({ down }) => !down)?.at ?? none, axes.find(({ down }) => down)?.at ?? none];
}

function pair(axis: Element, name: string): number[] {
  return (axis.getAttribute(name) ?? "").split(" ").map(Number);
}

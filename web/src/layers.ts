// Buttons that show and hide the layers of the drawing.
import { button, byId } from "./dom";
import { words } from "./format";
import type { Report } from "./model";

/** In the order of the buttons; any other role gets a button with its own name, at the end. */
const LAYERS: readonly (readonly [role: string, text: string, shown: boolean])[] = [
  ["body", "bodies", true],
  ["link", "links", true],
  ["joint", "joints", true],
  ["ground", "ground", true],
  ["gear", "gears", true],
  ["spring", "springs", true],
  ["linkage", "equivalent linkage", true],
  ["contact", "contact", true],
  ["normal", "normal", true],
  ["tangent", "tangent", false],
  ["curvature", "osculating circles", false],
  ["center", "instant centres", false],
  ["trace", "traces", true],
  ["driver", "driver", true],
  ["velocity", "velocities", false],
  ["acceleration", "accelerations", false],
  ["force", "forces", true],
  ["label", "names", true],
];

/** @param changed  is called when a layer is shown or hidden */
export function addLayers(report: Report, root: SVGSVGElement, changed: () => void): void {
  const present = new Set([...report.scene.fixed, ...report.scene.moving].map((shape) => shape.role));
  const known = LAYERS.filter(([role]) => present.has(role));
  const others = [...present].filter((role) => !LAYERS.some(([name]) => name === role));
  for (const [role, text, shown] of [...known, ...others.map((role) => [role, words(role), true] as const)]) {
    const toggle = button(text, { class: "layer", "data-layer": role }, () => {
      set(!isShown());
      changed();
    });
    const isShown = (): boolean => toggle.getAttribute("aria-pressed") === "true";
    const set = (on: boolean): void => {
      toggle.setAttribute("aria-pressed", String(on));
      root.classList.toggle(`hide-${role}`, !on);
    };
    set(shown);
    byId("layers").append(toggle);
  }
}

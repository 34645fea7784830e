// Light or dark colours: those of the system, unless the user chooses.
import { byId } from "./dom";

const THEMES = ["auto", "light", "dark"] as const;

/** @param changed  is called when the colours change */
export function addTheme(changed: () => void): void {
  const toggle = byId("theme");
  const system = matchMedia("(prefers-color-scheme: dark)");
  let theme: (typeof THEMES)[number] = "auto";
  const show = (): void => {
    document.documentElement.dataset["theme"] = theme !== "auto" ? theme : system.matches ? "dark" : "light";
    toggle.textContent = { auto: "◐ Auto", light: "☀ Light", dark: "☾ Dark" }[theme];
  };
  toggle.addEventListener("click", () => {
    theme = THEMES[(THEMES.indexOf(theme) + 1) % THEMES.length] ?? "auto";
    show();
    changed();
  });
  system.addEventListener("change", () => {
    show();
    changed();
  });
  show();
}

// Light or dark colours: those of the system, unless the user chooses.
import { byId } from "./dom";

const THEMES = ["auto", "light", "dark"] as const;

/** @param changed  is called when the colours change */
export function addTheme(changed: () => void): void {
  const toggle = byId("theme");
  let theme: (typeof THEMES)[number] = "auto";
  const show = (): void => {
    toggle.textContent = { auto: "◐ Auto", light: "☀ Light", dark: "☾ Dark" }[theme];
  };
  toggle.addEventListener("click", () => {
    theme = THEMES[(THEMES.indexOf(theme) + 1) % THEMES.length] ?? "auto";
    if (theme === "auto") delete document.documentElement.dataset["theme"];
    else document.documentElement.dataset["theme"] = theme;
    show();
    changed();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
  show();
}

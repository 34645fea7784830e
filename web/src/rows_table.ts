// A table of all rows of the plotted columns, for those who cannot see the plots.
import { byId, element } from "./dom";
import { number, unit } from "./format";
import type { Report, Rows } from "./model";
import type { Plots } from "./plots";

export function addRowsTable(report: Report, rows: Rows, driverColumn: number, plots: Plots): void {
  const panel = byId<HTMLDetailsElement>("rows-panel");
  const fill = (): void => {
    const place = panel.querySelector(".scroll");
    if (!panel.open || place === null) return;
    const columns = [driverColumn, ...plots.shownColumns.filter((k) => k !== driverColumn)];
    const head = columns.map((k) => {
      const column = report.columns[k];
      const shown = unit(column?.unit ?? "");
      return element("th", { scope: "col" }, (column?.name ?? "") + (shown === "" ? "" : ` [${shown}]`));
    });
    const body = element("tbody");
    for (let row = 0; row < rows.length; ++row) {
      body.append(element("tr", {}, ...columns.map((k) => element("td", { class: "number" }, number(rows.value(k, row), report.columns[k]?.noise)))));
    }
    place.replaceChildren(element("table", {}, element("thead", {}, element("tr", {}, ...head)), body));
  };
  panel.addEventListener("toggle", fill);
  plots.onChange(fill);
}

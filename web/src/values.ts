// The table of all values in the current row, with a button to plot each column.
import { button, byId, element } from "./dom";
import { number, unit } from "./format";
import type { Report, Rows } from "./model";
import type { Player } from "./player";
import type { Plots } from "./plots";

interface Line {
  readonly column: number;
  readonly value: HTMLElement;
  readonly toggle: HTMLButtonElement | null;
  readonly row: HTMLElement;
}

export class Values {
  private readonly lines: Line[] = [];
  private readonly groups: { readonly body: HTMLElement; readonly lines: Line[] }[] = [];

  constructor(
    private readonly report: Report,
    private readonly rows: Rows,
    player: Player,
    private readonly plots: Plots,
  ) {
    this.fill();
    player.onReadable((row) => this.show(row));
    plots.onChange(() => this.showPlotted());
    this.showPlotted();
    const search = byId<HTMLInputElement>("search");
    search.addEventListener("input", () => this.filter(search.value));
  }

  private fill(): void {
    const table = byId("value-table");
    let name = "";
    this.report.columns.forEach((column, k) => {
      const [first = ""] = column.name.split(".");
      if (first !== name || this.groups.length === 0) {
        name = first;
        const body = element("tbody");
        this.groups.push({ body, lines: [] });
        table.append(body);
      }
      const group = this.groups[this.groups.length - 1];
      const line = this.line(k);
      group?.body.append(line.row);
      group?.lines.push(line);
      this.lines.push(line);
    });
  }

  private line(k: number): Line {
    const column = this.report.columns[k];
    const name = column?.name ?? "";
    const value = element("td", { class: "number" });
    const toggle =
      column?.words === undefined
        ? button("", { class: "plot-toggle", "aria-label": `Plot ${name}`, title: `Plot ${name}` }, () => this.plots.toggle(k))
        : null;
    const last = element("td");
    if (toggle !== null) last.append(toggle);
    const row = element("tr", {}, element("th", { scope: "row" }, name), value, element("td", {}, unit(column?.unit ?? "")), last);
    return { column: k, value, toggle, row };
  }

  private show(row: number): void {
    for (const { column, value } of this.lines) {
      const here = this.rows.value(column, row);
      const words = this.report.columns[column]?.words;
      value.textContent = words === undefined || here === null ? number(here, this.report.columns[column]?.noise) : (words[here] ?? "–");
    }
  }

  private showPlotted(): void {
    const shown = new Set(this.plots.shownColumns);
    for (const { column, toggle } of this.lines) toggle?.setAttribute("aria-pressed", String(shown.has(column)));
  }

  private filter(text: string): void {
    const wanted = text.trim().toLowerCase().split(/\s+/);
    for (const { body, lines } of this.groups) {
      for (const { column, row } of lines) {
        const name = (this.report.columns[column]?.name ?? "").toLowerCase();
        row.hidden = !wanted.every((word) => name.includes(word));
      }
      body.hidden = lines.every(({ row }) => row.hidden);
    }
  }
}

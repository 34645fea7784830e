// The plots of the page, and the axis they are drawn against.
import { axes } from "./axes";
import { byId, element } from "./dom";
import { unit } from "./format";
import type { Report, Rows } from "./model";
import { type Axis, Plot, type PlotContext } from "./plot";
import type { Player } from "./player";

export class Plots {
  private plots: Plot[] = [];
  private readonly axes: Axis[];
  private axis: Axis;
  private readonly context: PlotContext;
  private readonly listeners: (() => void)[] = [];

  constructor(
    private readonly report: Report,
    rows: Rows,
    private readonly player: Player,
    private readonly columns: ReadonlyMap<string, number>,
    driverColumn: number,
  ) {
    this.axes = axes(report, rows, columns, driverColumn);
    this.axis = this.axes[0] as Axis;
    this.context = {
      columns: report.columns,
      rows,
      go: (row) => {
        player.pause();
        player.go(row);
      },
    };
    this.fillAxisChoice();
    this.fillColumnChoice();
    for (const names of report.plots) this.add(names.flatMap((name) => columns.get(name) ?? []));
    player.onRow((row) => this.plots.forEach((plot) => plot.moveTo(row)));
    player.onReadable(() => this.plots.forEach((plot) => plot.showValues()));
  }

  get shownColumns(): number[] {
    return [...new Set(this.plots.flatMap((plot) => plot.shownColumns))];
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Adds the column in a new plot, or removes it from all plots that show it. */
  toggle(column: number): void {
    const holders = this.plots.filter((plot) => plot.shownColumns.includes(column));
    if (holders.length === 0) this.add([column]);
    else holders.forEach((plot) => plot.toggle(column));
    this.changed();
  }

  /** Makes sure that some plot shows this column. */
  reveal(name: string): void {
    const column = this.columns.get(name);
    if (column === undefined) return;
    if (!this.plots.some((plot) => plot.shownColumns.includes(column))) this.add([column]);
  }

  redraw(): void {
    this.plots.forEach((plot) => plot.rebuild());
  }

  private add(columns: number[]): void {
    if (columns.length === 0) return;
    const plot = new Plot(columns, this.axis, this.context, (emptied) => this.remove(emptied));
    this.plots.push(plot);
    byId("plots").append(plot.element);
    plot.rebuild();
    plot.show(this.player.row);
    this.changed();
  }

  private remove(plot: Plot): void {
    plot.element.remove();
    this.plots = this.plots.filter((other) => other !== plot);
    this.changed();
  }

  private changed(): void {
    this.listeners.forEach((listener) => listener());
  }

  private fillAxisChoice(): void {
    const choice = byId<HTMLSelectElement>("x-axis");
    this.axes.forEach(({ name, unit: unitText }, i) => {
      const shown = unit(unitText);
      choice.append(element("option", { value: String(i) }, shown === "" ? name : `${name} [${shown}]`));
    });
    choice.addEventListener("change", () => {
      this.axis = this.axes[Number(choice.value)] ?? this.axis;
      this.plots.forEach((plot) => plot.setAxis(this.axis));
    });
  }

  private fillColumnChoice(): void {
    const names = byId("column-names");
    for (const column of this.report.columns) {
      if (column.words === undefined) names.append(element("option", { value: column.name }));
    }
    const input = byId<HTMLInputElement>("new-plot");
    const take = (): void => {
      const column = this.columns.get(input.value.trim());
      if (column === undefined) return;
      this.add([column]);
      input.value = "";
    };
    input.addEventListener("input", take);
    input.addEventListener("change", take);
  }
}

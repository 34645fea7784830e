// Assembles the page of a report.
import { byId, element } from "./dom";
import { embedded } from "./embedded";
import { addEvents } from "./events";
import { addFacts } from "./facts";
import { quantity } from "./format";
import { addLayers } from "./layers";
import { addLinkages } from "./linkage";
import type { Report, Rows } from "./model";
import { Player } from "./player";
import { Plots } from "./plots";
import { PointerControl } from "./pointer";
import { addFigures } from "./polygons";
import { addRowsTable } from "./rows_table";
import { addSaving } from "./save";
import { ScaleLegend } from "./scales";
import { Stage } from "./stage";
import { addTheme } from "./theme";
import { Transport } from "./transport";
import { Values } from "./values";
import { View } from "./view";

function addHeading(report: Report, rows: Rows): void {
  document.title = report.title;
  byId("title").textContent = report.title;
  const count = rows.length === report.size ? `${report.size} ${report.size === 1 ? "row" : "rows"}` : `one in ${Math.ceil((report.size - 1) / (rows.length - 1))} of ${report.size} rows; extremes and events are of all of them`;
  const verdict = element("span", report.good ? {} : { class: "not-good" }, `the whole path is ${report.good ? "good" : "not good"}`);
  byId("subtitle").append(`${count} · `, verdict, " · extremes with the driver’s position");
  byId("file").textContent = report.file;
  byId("source").textContent = report.source;
  byId("foot").textContent = `Made by higherpair ${report.version} · largest residual ${quantity(report.residual, report.lengthUnit)}`;
}

function start({ report, rows }: { report: Report; rows: Rows }): void {
  const columns = new Map(report.columns.map((column, k) => [column.name, k]));
  const driverColumn = columns.get(report.driver.column) ?? 0;
  const firstDriver = report.columns.findIndex(({ name }) => name.startsWith("driver")); // the driver that events refer to
  const unitOf = (k: number | undefined): string => (k === undefined ? "" : (report.columns[k]?.unit ?? ""));
  const player = new Player(rows, report, driverColumn);
  addHeading(report, rows);
  const stage = new Stage(report, rows);
  const legend = new ScaleLegend(report);
  const view = new View(stage.root, report, (scale) => {
    stage.setScale(scale);
    legend.show(scale);
  });
  player.onRow((row) => stage.show(row));
  new PointerControl(stage.root, report, rows, player, view);
  new Transport(report, rows, player, view, columns, driverColumn);
  addLayers(report, stage.root, () => stage.show(player.row));
  addTheme(() => plots.redraw()); // before the plots, which take their colours from the page
  const plots = new Plots(report, rows, player, columns, driverColumn);
  addFacts(report, unitOf(driverColumn), (row, column) => {
    player.pause();
    plots.reveal(column);
    player.go(row);
  });
  addEvents(report, unitOf(firstDriver), unitOf(columns.get("time")), player);
  addLinkages(report, rows, columns, player);
  addFigures(report, rows, player);
  new Values(report, rows, player, plots);
  addRowsTable(report, rows, driverColumn, plots);
  addSaving(report, rows, player, stage.root);
  player.go(0);
  expose(report, rows, player, stage);
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) player.play();
}

/** For tests and the browser console: the state of the page, read back from the drawing. */
function expose(report: Report, rows: Rows, player: Player, stage: Stage): void {
  const inUnits = (place: [number, number] | null): number[] | null =>
    place === null ? null : place.map((value) => value * report.lengthPerUnit);
  Object.assign(window, {
    higherpair: {
      get rows() {
        return Array.from({ length: rows.length }, (_, row) => report.columns.map((__, k) => rows.value(k, row)));
      },
      columns: report.columns,
      go: (row: number) => {
        player.pause();
        player.go(row);
      },
      state: () => ({
        row: player.row,
        playing: player.playing,
        joints: Object.fromEntries(report.joints.map(({ name, body, point }) => [name, inUnits(stage.drawn(body, point))])),
        contacts: Object.fromEntries(report.contacts.map((name) => [name, inUnits(stage.drawnContact(name))])),
      }),
    },
  });
}

start(embedded());

// The axes that plots can be drawn against: the driver, time, the rows.
import type { Report, Rows } from "./model";
import type { Axis } from "./plot";

/** The axes of a run: columns whose values are monotonic, and the row number. */
export function axes(report: Report, rows: Rows, columns: ReadonlyMap<string, number>, driverColumn: number): Axis[] {
  const found: Axis[] = [];
  const bad = badRows(report, rows, columns);
  for (const k of [driverColumn, columns.get("time")]) {
    const column = k === undefined ? undefined : report.columns[k];
    if (k === undefined || column === undefined) continue;
    const values = rows.values(k);
    const order = values.map((_, row) => row);
    if ((values[0] ?? 0) > (values[values.length - 1] ?? 0)) order.reverse();
    const sorted = order.map((row) => values[row] ?? NaN);
    if (!sorted.every((value, i) => i === 0 || value > (sorted[i - 1] ?? NaN))) continue;
    const isTime = column.name === "time";
    // Events are given at the position of the first driver.
    const ofFirst = report.columns.findIndex(({ name }) => name.startsWith("driver")) === k;
    found.push({
      name: column.name,
      unit: column.unit,
      values: sorted,
      rows: order,
      marks: report.events.flatMap((event) => (isTime ? (event.time ?? []) : ofFirst ? event.driver : (values[event.row] ?? []))),
      bad: stretches(bad, (row) => values[row] ?? 0),
    });
  }
  const order = Array.from({ length: rows.length }, (_, row) => row);
  found.push({
    name: "row",
    unit: "1",
    values: order,
    rows: order,
    marks: report.events.map((event) => event.row),
    bad: stretches(bad, (row) => row),
  });
  return found;
}

// First and last row of each stretch that is not ok.
function badRows(report: Report, rows: Rows, columns: ReadonlyMap<string, number>): [number, number][] {
  const k = columns.get("status");
  if (k === undefined) return [];
  const ok = report.columns[k]?.words?.indexOf("ok");
  const found: [number, number][] = [];
  rows.values(k).forEach((value, row) => {
    if (value === ok) return;
    const last = found[found.length - 1];
    if (last !== undefined && last[1] === row - 1) last[1] = row;
    else found.push([row, row]);
  });
  return found;
}

function stretches(bad: readonly (readonly [number, number])[], at: (row: number) => number): [number, number][] {
  return bad.map(([from, to]) => {
    const ends = [at(from), at(to)];
    return [Math.min(...ends), Math.max(...ends)];
  });
}

// The report that lies in the page itself.
import type { Column, Numbers, Report, Rows } from "./model";

interface EmbeddedReport extends Omit<Report, "columns"> {
  readonly columns: readonly (Column & { readonly values: readonly (number | null)[] })[];
  readonly places: readonly (readonly number[] | null)[];
  readonly moving: readonly (readonly Numbers[])[];
}

class EmbeddedRows implements Rows {
  readonly length: number;
  private readonly columns: readonly (readonly (number | null)[])[];

  constructor(private readonly report: EmbeddedReport) {
    this.length = report.places.length;
    // What is the same in every row is written once.
    this.columns = report.columns.map(({ values }) =>
      values.length === this.length ? values : new Array<number | null>(this.length).fill(values[0] ?? null),
    );
  }

  value(column: number, row: number): number | null {
    return this.columns[column]?.[row] ?? null;
  }
  values(column: number): readonly (number | null)[] {
    return this.columns[column] ?? [];
  }
  places(row: number): readonly number[] | null {
    return this.report.places[row] ?? null;
  }
  moving(row: number): readonly Numbers[] {
    return this.report.moving[row] ?? [];
  }
}

export function embedded(): { report: Report; rows: Rows } {
  const report = JSON.parse(document.getElementById("report-data")?.textContent ?? "") as EmbeddedReport;
  return { report, rows: new EmbeddedRows(report) };
}

// The report that is embedded in the page.
import type { Column, MapPlace, Numbers, Polygon, Report, Rows, Vector } from "./model";
import { type Packed, unpack } from "./packed";

interface EmbeddedReport extends Omit<Report, "columns" | "polygons"> {
  readonly count: number;
  readonly columns: readonly (Column & { readonly values: Packed })[];
  readonly places: readonly Packed[];
  readonly moving: readonly (readonly Packed[])[];
  readonly polygons: readonly (Polygon & { readonly equationsOf: Packed; readonly vectors: readonly (readonly [Packed, Packed])[] })[];
  readonly maps: readonly (Report["maps"][number] & Record<"x" | "y" | "branch", Packed>)[];
}

type Values = readonly (number | null)[];

class EmbeddedRows implements Rows {
  readonly length: number;
  private readonly unpacked = new Map<Packed, Values>();

  constructor(private readonly report: EmbeddedReport) {
    this.length = report.count;
  }

  value(column: number, row: number): number | null {
    return this.values(column)[row] ?? null;
  }
  values(column: number): Values {
    return this.all(this.report.columns[column]?.values);
  }
  places(row: number): readonly number[] | null {
    const places = this.report.places.map((packed) => this.all(packed)[row] ?? null);
    return places.includes(null) ? null : (places as number[]);
  }
  shape(shape: number, row: number): Numbers {
    const numbers = (this.report.moving[shape] ?? []).map((packed) => this.all(packed)[row] ?? null);
    while (numbers[numbers.length - 1] === null) numbers.pop();
    return numbers;
  }
  vector(polygon: number, vector: number, row: number): Vector | null {
    const [x, y] = (this.report.polygons[polygon]?.vectors[vector] ?? []).map((packed) => this.all(packed)[row] ?? null);
    return x === undefined || y === undefined || x === null || y === null ? null : [x, y];
  }
  equations(polygon: number, row: number): number | null {
    return this.all(this.report.polygons[polygon]?.equationsOf)[row] ?? null;
  }
  place(map: number, row: number): MapPlace | null {
    const packed = this.report.maps[map];
    const [x, y, branch] = [packed?.x, packed?.y, packed?.branch].map((one) => this.all(one)[row] ?? null);
    return x == null || y == null || branch == null ? null : { x, y, branch };
  }

  // Unpacks on first use, so that values never looked at stay packed.
  private all(packed: Packed | undefined): Values {
    if (packed === undefined) return [];
    const known = this.unpacked.get(packed);
    if (known !== undefined) return known;
    const values = unpack(packed, this.length);
    this.unpacked.set(packed, values);
    return values;
  }
}

export function embedded(): { report: Report; rows: Rows } {
  const report = JSON.parse(document.getElementById("report-data")?.textContent ?? "") as EmbeddedReport;
  return { report, rows: new EmbeddedRows(report) };
}

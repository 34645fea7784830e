// What the program has worked out, as the page receives it. Lengths of the scene are in mm, angles in rad.

export interface Column {
  readonly name: string;
  readonly unit: string;
  /** What is no larger is rounding. */
  readonly noise: number;
  /** Of a column of words: its values are indices of these. */
  readonly words?: readonly string[];
}

export type ShapeKind = "path" | "circle" | "arrow" | "text";

export interface Shape {
  readonly role: string;
  readonly kind: ShapeKind;
  readonly name: string;
  /** Whose frame the numbers are in; none: ground. */
  readonly body?: number;
  readonly closed?: boolean;
  /** Of a moving text: the name of the length that is its fifth number [mm]. */
  readonly text?: string;
  readonly colour?: string;
  /** Not filled although closed. */
  readonly outline?: boolean;
}

/** The coordinates of a shape; null between the pieces of a path; empty where it is not defined. */
export type Numbers = readonly (number | null)[];

export interface Scene {
  readonly view: readonly [number, number, number, number];
  readonly unit: number;
  readonly bodies: readonly string[];
  readonly fixed: readonly (Shape & { readonly numbers: Numbers })[];
  readonly moving: readonly Shape[];
  /** What arrows of one unit are long [mm]; by their roles. Torques are arcs, which turn [rad]. */
  readonly scales: { readonly [role: string]: { readonly unit: string; readonly length?: number; readonly turn?: number } };
}

/** Names have `_{…}` for lowered and `^{…}` for raised text. Vectors are rows' ones, by their numbers. */
export interface Polygon {
  readonly title: string;
  readonly forces: boolean;
  readonly unit: string;
  readonly view: readonly [number, number, number, number];
  /** All arrows are on one line in every row, and are to be drawn side by side. */
  readonly flat: boolean;
  readonly equations: readonly string[];
  readonly points: readonly { readonly name: string; readonly at: number }[];
  readonly arrows: readonly { readonly kind: string; readonly name: string; readonly item: string; readonly from: number; readonly to: number }[];
}

/** The configuration space of a contact as an SVG picture; its axes have data-domain and data-range. */
export interface ContactMap {
  readonly contact: string;
  readonly picture: string;
}

export type Vector = readonly [number, number];

export interface MapPlace {
  readonly x: number;
  readonly y: number;
  /** From 1. */
  readonly branch: number;
}

export interface Driver {
  readonly joint: string;
  /** Of its position. */
  readonly column: string;
  readonly body: number;
  /** A full turn in the unit of the column `driver`; null of a slide. */
  readonly turn: number | null;
}

export interface Fact {
  readonly of: string;
  readonly name: string;
  readonly value: number;
  readonly unit: string;
  readonly column: string;
  readonly at: readonly { readonly value: number; readonly driver: number; readonly row: number }[];
}

export interface MotionEvent {
  readonly type: string;
  readonly driver: number;
  readonly time?: number;
  readonly row: number;
  readonly item: string;
  readonly cause: string;
  /** Of what reverses. */
  readonly value?: number;
  readonly unit?: string;
}

export interface Report {
  readonly title: string;
  readonly description: string;
  readonly version: string;
  readonly file: string;
  readonly source: string;
  readonly residual: number;
  readonly good: boolean;
  /** Rows of the run; the page may hold fewer. */
  readonly size: number;
  readonly lengthUnit: string;
  readonly lengthPerMm: number;
  readonly driver: Driver;
  readonly joints: readonly { readonly name: string; readonly at: string; readonly body: number; readonly point: readonly [number, number] }[];
  readonly contacts: readonly string[];
  readonly facts: readonly Fact[];
  readonly plots: readonly (readonly string[])[];
  readonly events: readonly MotionEvent[];
  readonly columns: readonly Column[];
  readonly scene: Scene;
  readonly polygons: readonly Polygon[];
  readonly maps: readonly ContactMap[];
  /** The last row shows the same picture as the first. */
  readonly closed: boolean;
}

/** Where the rows come from: the page asks for nothing else, whether they lie in it or arrive while it is open. */
export interface Rows {
  readonly length: number;
  /** Of a column by its number; null where it is not defined. */
  value(column: number, row: number): number | null;
  values(column: number): readonly (number | null)[];
  /** x, y, theta of every body; null where the row has no position. */
  places(row: number): readonly number[] | null;
  /** Of a moving shape by its number. */
  shape(shape: number, row: number): Numbers;
  /** Of a polygon, by their numbers; null where it is not defined. */
  vector(polygon: number, vector: number, row: number): Vector | null;
  /** Of a map by its number. */
  place(map: number, row: number): MapPlace | null;
}

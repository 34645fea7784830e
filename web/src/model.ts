// The results of the program, as the page receives them. Lengths of the scene are in a unit that suits its size, angles in rad.

export interface Column {
  readonly name: string;
  readonly unit: string;
  /** Values up to this are rounding errors. */
  readonly noise: number;
  /** For a column of words: the words that its values are indices of. */
  readonly words?: readonly string[];
  /** Rows that jump, so that no line joins them to the row before. */
  readonly breaks?: readonly number[];
}

export type ShapeKind = "path" | "circle" | "arrow" | "text";

export interface Shape {
  readonly role: string;
  readonly kind: ShapeKind;
  readonly name: string;
  /** Index of the body in whose frame the numbers are; absent: ground. */
  readonly body?: number;
  readonly closed?: boolean;
  /** For a moving text: the name of the length given by its fifth number [units]; for other shapes what a pointer on them is told. */
  readonly text?: string;
  readonly colour?: string;
  /** Not filled although it is closed. */
  readonly outline?: boolean;
}

/** The coordinates of a shape; null separates the pieces of a path; empty if it is undefined. */
export type Numbers = readonly (number | null)[];

export interface Scene {
  readonly view: readonly [number, number, number, number];
  readonly unit: number;
  readonly bodies: readonly string[];
  readonly fixed: readonly (Shape & { readonly numbers: Numbers })[];
  readonly moving: readonly Shape[];
  /** By role of arrow: the length of one that stands for 1 of `unit`. Torques are arcs, whose angle per unit is `turn` [rad]. */
  readonly scales: { readonly [role: string]: { readonly unit: string; readonly length?: number; readonly turn?: number } };
}

/** In names `_{…}` is a subscript and `^{…}` a superscript. Points and arrows refer by index to the vectors of a row. */
export interface Polygon {
  readonly title: string;
  readonly forces: boolean;
  readonly unit: string;
  readonly view: readonly [number, number, number, number];
  /** All arrows are on one line in every row, so they have to be drawn side by side. */
  readonly flat: boolean;
  /** Name of the point (0, 0); empty for forces. */
  readonly pole: string;
  /** The different sets of equations; which one holds depends on the row. */
  readonly equations: readonly (readonly string[])[];
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
  /** Counted from 1. */
  readonly branch: number;
}

export interface Driver {
  /** Name of the column of its position. */
  readonly column: string;
  readonly body: number;
  /** A full turn in the unit of the column `driver`; null for a slide. */
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
  /** Position of the joint that reverses. */
  readonly value?: number;
  readonly unit?: string;
}

export interface Report {
  readonly title: string;
  readonly version: string;
  readonly file: string;
  readonly source: string;
  readonly residual: number;
  readonly good: boolean;
  /** Number of rows of the run; the page may contain fewer. */
  readonly size: number;
  readonly lengthUnit: string;
  /** Of a unit of the scene, in lengthUnit. */
  readonly lengthPerUnit: number;
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
  /** Whether the last row shows the same picture as the first. */
  readonly closed: boolean;
}

/** The source of the rows: the page depends on nothing else, whether they are embedded or arrive while it is open. */
export interface Rows {
  readonly length: number;
  /** Value of a column by its index; null if it is undefined. */
  value(column: number, row: number): number | null;
  values(column: number): readonly (number | null)[];
  /** x, y, theta of every body; null if the row has no position. */
  places(row: number): readonly number[] | null;
  /** Numbers of a moving shape by its index. */
  shape(shape: number, row: number): Numbers;
  /** Vector of a polygon, both by index; null if it is undefined. */
  vector(polygon: number, vector: number, row: number): Vector | null;
  /** Index of the set of equations of a polygon; null if it is undefined. */
  equations(polygon: number, row: number): number | null;
  /** Position in a map by its index. */
  place(map: number, row: number): MapPlace | null;
}

// Which row is shown, and the animation through the rows.
import type { Report, Rows } from "./model";

const SECONDS_PER_PASS = 6;
const REFRESH = 80; // ms between two updates of numbers during the animation, so that they can be read

export class Player {
  row = 0;
  speed = 1;
  private position = 0; // in rows, including a fraction
  private sense = 1;
  private last: number | null = null; // time of the previous frame [ms]
  private readonly listeners: ((row: number) => void)[] = [];
  private readonly stateListeners: ((playing: boolean) => void)[] = [];
  private readonly seconds: number;

  constructor(
    readonly rows: Rows,
    private readonly report: Report,
    driverColumn: number,
  ) {
    this.seconds = SECONDS_PER_PASS * Math.max(1, this.turns(driverColumn));
  }

  private turns(driverColumn: number): number {
    const first = this.rows.value(driverColumn, 0) ?? 0;
    const last = this.rows.value(driverColumn, this.rows.length - 1) ?? 0;
    return this.report.driver.turn === null ? 1 : Math.abs((last - first) / this.report.driver.turn);
  }

  onRow(listener: (row: number) => void): void {
    this.listeners.push(listener);
  }
  /** For numbers: during the animation not called for every row, which would be too fast to read. */
  onReadable(listener: (row: number) => void): void {
    let last = 0;
    const show = (row: number): void => {
      last = performance.now();
      listener(row);
    };
    this.onRow((row) => {
      if (!this.playing || performance.now() - last >= REFRESH) show(row);
    });
    this.onPlaying(() => show(this.row));
  }
  onPlaying(listener: (playing: boolean) => void): void {
    this.stateListeners.push(listener);
  }

  get playing(): boolean {
    return this.last !== null;
  }

  go(row: number): void {
    const next = Math.min(Math.max(Math.round(row), 0), this.rows.length - 1);
    this.position = next;
    this.show(next);
  }

  step(rows: number): void {
    this.pause();
    const count = this.rows.length;
    // The last row of a closed motion shows the same picture as the first.
    const next = this.row + rows;
    this.go(this.report.closed && (next < 0 || next >= count) ? (next + count - 1) % (count - 1) : next);
  }

  play(): void {
    if (this.playing || this.rows.length < 2) return;
    if (!this.report.closed && this.row === this.rows.length - 1) this.sense = -1;
    if (this.row === 0) this.sense = 1;
    this.position = this.row;
    this.last = performance.now();
    this.stateListeners.forEach((listener) => listener(true));
    requestAnimationFrame((now) => this.frame(now));
  }

  pause(): void {
    if (!this.playing) return;
    this.last = null;
    this.stateListeners.forEach((listener) => listener(false));
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  private frame(now: number): void {
    if (this.last === null) return;
    const elapsed = Math.min(Math.max(now - this.last, 0), 100) / 1000;
    this.last = now;
    this.advance((elapsed * this.speed * (this.rows.length - 1)) / this.seconds);
    this.show(Math.round(this.position));
    requestAnimationFrame((next) => this.frame(next));
  }

  // Goes round and round if the motion is closed, otherwise to and fro.
  private advance(way: number): void {
    const end = this.rows.length - 1;
    this.position += this.sense * way;
    if (this.report.closed) {
      this.position = ((this.position % end) + end) % end;
    } else if (this.position > end || this.position < 0) {
      this.sense = this.position > end ? -1 : 1;
      this.position = Math.min(Math.max(this.position, 0), end);
    }
  }

  private show(row: number): void {
    this.row = row;
    this.listeners.forEach((listener) => listener(row));
  }
}

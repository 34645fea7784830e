// Play, pause, speed, single steps, the slider with its events, and their keyboard shortcuts.
import { byId, element } from "./dom";
import { number, quantity, words } from "./format";
import type { Report, Rows } from "./model";
import type { Player } from "./player";
import { ZOOM, type View } from "./view";

const PAGE = 10; // rows per step with the shift key

const STATUS: Readonly<Record<string, string>> = {
  not_assemblable: "cannot be assembled here",
  singular: "singular position: some rates are not defined",
  overlap: "the touching bodies overlap elsewhere",
  not_converged: "not accurate: the residual exceeds the tolerance",
  contact_open: "a contact would have to pull here: it opens",
  law_jump: "velocity or acceleration of the driver jumps",
};

export class Transport {
  private readonly slider = byId<HTMLInputElement>("row");
  private readonly playButton = byId<HTMLButtonElement>("play");

  constructor(
    private readonly report: Report,
    private readonly rows: Rows,
    private readonly player: Player,
    private readonly view: View,
    private readonly columns: ReadonlyMap<string, number>,
    private readonly driverColumn: number,
  ) {
    this.slider.max = String(rows.length - 1);
    this.slider.addEventListener("input", () => {
      player.pause();
      player.go(this.slider.valueAsNumber);
    });
    this.playButton.addEventListener("click", () => player.toggle());
    byId("back").addEventListener("click", () => player.step(-1));
    byId("forth").addEventListener("click", () => player.step(1));
    byId<HTMLSelectElement>("speed").addEventListener("change", (event) => {
      player.speed = Number((event.target as HTMLSelectElement).value);
    });
    byId("fullscreen").addEventListener("click", () => this.fullscreen());
    byId("driven-name").textContent = report.scene.bodies[report.driver.body] ?? "driven body";
    player.onPlaying((playing) => this.showPlaying(playing));
    player.onRow((row) => this.show(row));
    document.addEventListener("keydown", (event) => this.key(event));
    this.addMarks();
  }

  private addMarks(): void {
    const end = Math.max(this.rows.length - 1, 1);
    for (const event of this.report.events) {
      const mark = element("span", { class: `mark ${event.type}`, title: `${words(event.type)}: ${event.cause}` });
      mark.style.setProperty("--at", String(event.row / end));
      byId("marks").append(mark);
    }
  }

  private showPlaying(playing: boolean): void {
    this.playButton.textContent = playing ? "❚❚" : "▶";
    this.playButton.setAttribute("aria-label", playing ? "Pause" : "Play");
    if (!playing) byId("live").textContent = byId("place").textContent;
  }

  private show(row: number): void {
    this.slider.valueAsNumber = row;
    const text = [this.coordinate("time", row), this.coordinate("driver", row)].filter((part) => part !== "").join(" · ");
    byId("place").textContent = text;
    this.slider.setAttribute("aria-valuetext", text);
    const status = this.status(row);
    const banner = byId("banner");
    banner.hidden = status === "ok" || status === "";
    banner.textContent = STATUS[status] ?? words(status);
  }

  private coordinate(name: string, row: number): string {
    const k = name === "driver" ? this.driverColumn : this.columns.get(name);
    const column = k === undefined ? undefined : this.report.columns[k];
    if (k === undefined || column === undefined) return "";
    return `${column.name} ${quantity(this.rows.value(k, row), column.unit)}`;
  }

  private status(row: number): string {
    const k = this.columns.get("status");
    const value = k === undefined ? null : this.rows.value(k, row);
    return k === undefined || value === null ? "" : (this.report.columns[k]?.words?.[value] ?? number(value));
  }

  private fullscreen(): void {
    if (document.fullscreenElement !== null) void document.exitFullscreen();
    else void byId("stage").parentElement?.requestFullscreen();
  }

  private key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    const types = target.matches("input:not([type=range]), select, textarea");
    if (types || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === " " && target.matches("button, summary, a")) return;
    const rows = event.shiftKey ? PAGE : 1;
    const actions: Readonly<Record<string, () => void>> = {
      " ": () => this.player.toggle(),
      ArrowLeft: () => this.player.step(-rows),
      ArrowRight: () => this.player.step(rows),
      Home: () => this.goAndPause(0),
      End: () => this.goAndPause(this.rows.length - 1),
      "+": () => this.view.zoom(ZOOM),
      "-": () => this.view.zoom(1 / ZOOM),
      "0": () => this.view.fit(),
      f: () => this.fullscreen(),
    };
    const action = actions[event.key];
    if (action === undefined) return;
    event.preventDefault();
    action();
  }

  private goAndPause(row: number): void {
    this.player.pause();
    this.player.go(row);
  }
}

// The list of events on the path, in words.
import { button, byId, element } from "./dom";
import { quantity, words } from "./format";
import type { Report } from "./model";
import type { Player } from "./player";

export function addEvents(report: Report, driverUnit: string, timeUnit: string, player: Player): void {
  byId("events-panel").hidden = report.events.length === 0;
  const items = report.events.map((event) => {
    const where = event.time === undefined ? quantity(event.driver, driverUnit) : `${quantity(event.time, timeUnit)}, ${quantity(event.driver, driverUnit)}`;
    const go = button(where, { class: "where" }, () => {
      player.pause();
      player.go(event.row);
    });
    const title = event.item === "" ? words(event.type) : `${words(event.type)}: ${event.item}`;
    return element("li", { class: event.type }, element("b", {}, title), " ", go, element("p", {}, event.cause + (event.value === undefined ? "" : `, at ${quantity(event.value, event.unit ?? "")}`)));
  });
  byId("events").append(...items);
  player.onRow((row) => {
    report.events.forEach((event, i) => items[i]?.classList.toggle("here", event.row === row));
  });
}

// The main results: stroke, extreme speeds, pressure angle, and where each occurs.
import { button, byId, element } from "./dom";
import { quantity } from "./format";
import type { Fact, Report } from "./model";

const DIGITS = 5;

/** @param chosen  is called with the row and the column of a fact that is clicked */
export function addFacts(report: Report, driverUnit: string, chosen: (row: number, column: string) => void): void {
  const groups = new Map<string, Fact[]>();
  for (const fact of report.facts) groups.set(fact.of, [...(groups.get(fact.of) ?? []), fact]);
  for (const [of, facts] of groups) {
    const list = element("dl");
    for (const fact of facts) list.append(...lines(fact, driverUnit, chosen));
    byId("facts").append(element("article", { class: "card" }, element("h2", {}, of), list));
  }
}

function lines(fact: Fact, driverUnit: string, chosen: (row: number, column: string) => void): HTMLElement[] {
  const value = element("strong", {}, quantity(fact.value, fact.unit, 0, DIGITS));
  const where = element("span", { class: "where" }, fact.at.length === 0 ? "everywhere" : fact.at.length > 1 ? "" : "at ");
  // A driver that stands still tells no place.
  const still = fact.at.length > 1 && fact.at.every(({ driver }) => driver === fact.at[0]?.driver);
  fact.at.forEach(({ value: here, driver, row }, i) => {
    const place = still ? `row ${row + 1}` : quantity(driver, driverUnit);
    const title = `${quantity(here, fact.unit)} at ${still ? place : `driver = ${place}`}: show it`;
    if (i > 0) where.append(" → ");
    where.append(button(place, { class: "where", title }, () => chosen(row, fact.column)));
  });
  return [element("dt", {}, fact.name), element("dd", {}, value), element("dd", {}, where)];
}

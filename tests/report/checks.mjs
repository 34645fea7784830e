// Findings of the browser test: failures are collected, and all are printed at the end.

export class Checks {
  failures = [];
  count = 0;

  constructor(name) {
    this.name = name;
  }

  true(holds, what) {
    this.count += 1;
    if (!holds) this.failures.push(`${this.name}: ${what}`);
  }
  equal(found, expected, what) {
    this.true(Object.is(found, expected), `${what}: ${JSON.stringify(found)}, not ${JSON.stringify(expected)}`);
  }
  near(found, expected, bound, what) {
    this.true(Math.abs(found - expected) <= bound, `${what}: ${found}, not ${expected} within ${bound}`);
  }
}

/** The table of `analyze` as { names, rows }, rows by name. */
export function parseCsv(text) {
  const [head, ...lines] = text.trimEnd().split("\n");
  const names = head.split(",").map((name) => name.replace(/\[.*/, ""));
  const rows = lines.map((line) => {
    const fields = line.split(",");
    return Object.fromEntries(names.map((name, i) => [name, fields[i]]));
  });
  return { names, rows };
}

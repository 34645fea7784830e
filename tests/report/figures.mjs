// Polygons and contact maps of the row that is shown, compared with the table of `analyze`.

const DIGITS = 2e-3; // lengths are shown with four digits, small ones in a polygon with fewer

/** The velocities that the polygon lists are those of the table, and its arrows have the lengths that it states. */
async function checkVelocities(page, table, row, checks) {
  const arrows = await page.evaluate(() => {
    const { polygons } = JSON.parse(document.getElementById("report-data").textContent);
    const index = polygons.findIndex(({ title }) => title === "Velocities");
    const figure = [...document.querySelectorAll(".figure.beside")][index];
    if (figure === undefined) return [];
    const lines = [...figure.querySelectorAll("svg.polygon path.head")];
    return polygons[index].arrows.map(({ kind, item }, i) => ({
      kind,
      item,
      text: figure.querySelectorAll(".arrows > div")[i].querySelector(".number").textContent,
      drawn: !lines[i].classList.contains("absent"),
    }));
  });
  const speeds_in = (one) => arrows.map(({ item }) => Math.hypot(Number(one[`${item}.vx`]), Number(one[`${item}.vy`])));
  const speeds = speeds_in(row);
  // The page treats what is small compared with the whole motion as at rest.
  const largest = Math.max(...table.rows.flatMap(speeds_in).filter((speed) => !Number.isNaN(speed)));
  arrows.forEach(({ kind, item, text, drawn }, i) => {
    if (kind !== "absolute" || Number.isNaN(speeds[i])) return;
    if (text !== "–") checks.near(Number(text.replace("·10", "e")), speeds[i], DIGITS * largest, `speed of ${item}`);
    else checks.true(speeds[i] <= DIGITS * largest + 1e-9, `speed of ${item} is missing`);
    if (speeds[i] > 0.2 * largest) checks.true(drawn, `the arrow of ${item} is not drawn`);
  });
}

/** The equations beside a polygon are about the arrows of this row, and the pole has a name that no point has. */
async function checkEquations(page, checks) {
  const figures = await page.evaluate(() =>
    [...document.querySelectorAll(".figure.beside")].map((figure) => ({
      equations: figure.querySelector(".equations").textContent,
      arrows: [...figure.querySelectorAll(".arrows > div:not(.gone)")]
        .filter((arrow) => arrow.querySelector(".v-absolute") === null)
        .map((arrow) => arrow.children[1].textContent),
      names: [...figure.querySelectorAll("svg.polygon .name:not(.absent)")].map((name) => name.textContent),
    })),
  );
  for (const { equations, arrows, names } of figures) {
    checks.equal(new Set(names).size, names.length, `points of one name: ${names}`);
    if (equations === "") continue;
    for (const arrow of arrows) checks.true(equations.includes(arrow), `${arrow} is in no equation: ${equations}`);
  }
}

/** The map shows the point on the branch whose number is given; none where the bodies are apart. */
async function checkMaps(page, row, checks) {
  const maps = await page.evaluate(() =>
    [...document.querySelectorAll(".map")].map((map) => {
      const point = map.querySelector("i");
      const [a, b] = [map.querySelector("img").getBoundingClientRect(), point.getBoundingClientRect()];
      const [x, y] = [(b.left + b.right) / 2, (b.top + b.bottom) / 2];
      const inside = x > a.left && x < a.right && y > a.top && y < a.bottom;
      const contact = map.parentElement.querySelector("h3 b").textContent.replace("Map of contact ", "");
      return { contact, hidden: point.hidden, inside, text: map.parentElement.querySelector("h3 span").textContent };
    }),
  );
  for (const { contact, hidden, inside, text } of maps) {
    checks.true(hidden || inside, "the point is out of the map");
    checks.equal(/^on branch \d+$/.test(text), !hidden, `branch of the map: "${text}"`);
    if (row.status === "ok") checks.equal(hidden, row[`${contact}.x`] === "", `a row of ${contact} is in no map`);
  }
}

export async function checkFigures(page, table, checks) {
  const row = Math.round(table.rows.length / 5);
  await page.evaluate((shown) => higherpair.go(shown), row);
  await checkVelocities(page, table, table.rows[row], checks);
  await checkEquations(page, checks);
  await checkMaps(page, table.rows[row], checks);
  const middle = Math.round(table.rows.length / 2);
  await page.evaluate((shown) => higherpair.go(shown), middle);
  await checkMaps(page, table.rows[middle], checks);
  await checkEquations(page, checks);
}

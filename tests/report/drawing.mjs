// What is drawn, read back from the page and compared with the table of `analyze`.

const NEAR = 2e-6; // relative to the picture: coordinates are stored with eight digits

/** Positions of joints and contacts, and that names do not cover each other. */
export async function checkDrawing(page, table, checks) {
  const count = table.rows.length;
  for (const row of [0, Math.round(count / 7), Math.round(count / 2), count - 1]) {
    await page.evaluate((shown) => higherpair.go(shown), row);
    await checkRow(page, table, row, checks);
    checks.equal(await overlappingNames(page), "", `names cover each other in row ${row}`);
  }
  await checkValues(page, table, Math.round(count / 7), checks);
}

/** That this row is shown, with everything at its position. */
export async function checkRow(page, table, row, checks) {
  const scene = await page.evaluate(() => {
    const report = JSON.parse(document.getElementById("report-data").textContent);
    const [x0, y0, x1, y1] = report.scene.view;
    return { joints: report.joints, size: Math.hypot(x1 - x0, y1 - y0) * report.lengthPerUnit };
  });
  const state = await page.evaluate(() => higherpair.state());
  checks.equal(state.row, row, "row that is shown");
  checkPlaces(state, table.rows[row], scene, checks);
}

/** The page's numbers are those of the table, to the accuracy that packing leaves. */
async function checkValues(page, table, row, checks) {
  const columns = await page.evaluate((at) => {
    const { rows, columns: all } = higherpair;
    return all.map(({ name, words }, k) => ({
      name,
      value: words === undefined ? rows[at][k] : (words[rows[at][k]] ?? ""),
      largest: words === undefined ? rows.reduce((most, one) => Math.max(most, Math.abs(one[k] ?? 0)), 0) : 0,
    }));
  }, row);
  for (const { name, value, largest } of columns) {
    const expected = table.rows[row][name];
    if (expected === undefined || name === "status") continue; // with forces a row may be `contact_open`
    if (value === null || typeof value === "string") checks.equal(value ?? "", expected, `${name} in row ${row}`);
    else checks.near(value, Number(expected), 2e-10 * largest + 1e-12, `${name} in row ${row}`);
  }
}

function checkPlaces(state, row, { joints, size }, checks) {
  const lost = row.status === "not_assemblable";
  for (const { name, at } of joints) {
    const place = state.joints[name];
    checks.equal(place === null, lost, `joint ${name} is drawn where the row says ${row.status}`);
    if (place === null || row[`${at}.x`] === undefined) continue;
    checks.near(place[0], Number(row[`${at}.x`]), NEAR * size, `${name} x at driver ${row.driver}`);
    checks.near(place[1], Number(row[`${at}.y`]), NEAR * size, `${name} y at driver ${row.driver}`);
  }
  for (const [name, place] of Object.entries(state.contacts)) {
    const open = lost || row[`${name}.x`] === ""; // a contact that may separate has no position while open
    checks.equal(place === null, open, `contact ${name} is drawn where the row says ${row.status}`);
    if (place === null) continue;
    checks.near(place[0], Number(row[`${name}.x`]), 10 * NEAR * size, `${name} x at driver ${row.driver}`);
    checks.near(place[1], Number(row[`${name}.y`]), 10 * NEAR * size, `${name} y at driver ${row.driver}`);
  }
}

/** Links that leave the picture are broken off: their labels show the table's lengths, within the picture. */
export async function checkBrokenLinks(page, table, row, checks) {
  await page.evaluate((shown) => higherpair.go(shown), row);
  const texts = await page.evaluate(() =>
    [...document.querySelectorAll('#drawing text[data-role="linkage"]:not(.absent)')].map((text) => {
      const [a, b] = [text.getBoundingClientRect(), document.getElementById("drawing").getBoundingClientRect()];
      return { text: text.textContent, inside: a.left >= b.left && a.right <= b.right && a.top >= b.top && a.bottom <= b.bottom };
    }),
  );
  checks.true(texts.every(({ inside }) => inside), "a length is out of the picture");
  checks.equal(texts.length, 2, "links that are broken off");
  for (const name of ["r2", "r3"]) {
    const length = Math.abs(Number(table.rows[row][`touch.${name}`]));
    const found = texts.find(({ text }) => text.startsWith(`${name} = `))?.text ?? "";
    checks.near(Number(found.replace(/.*= | mm/g, "")), length, 1e-3 * length, `${name} that is written`);
  }
}

/** The hollow of a ring is not filled. */
export async function checkHollow(page, checks) {
  const rule = await page.evaluate(() => getComputedStyle(document.querySelector('#drawing [data-role="body"].closed')).fillRule);
  checks.equal(rule, "evenodd", "how rings are filled");
}

function overlappingNames(page) {
  return page.evaluate(() => {
    const shown = [...document.querySelectorAll("#drawing text")].filter((text) => getComputedStyle(text).display !== "none");
    const boxes = shown.map((text) => [text.textContent, text.getBoundingClientRect()]);
    const found = [];
    boxes.forEach(([a, p], i) =>
      boxes.slice(i + 1).forEach(([b, q]) => {
        const across = Math.min(p.right, q.right) - Math.max(p.left, q.left);
        const down = Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top);
        if (across > 2 && down > 5) found.push(`${a}/${b}`);
      }),
    );
    return found.join(" ");
  });
}

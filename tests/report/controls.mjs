// Slider, keys, layers, plots and the driven body itself change what is shown.

import { checkRow } from "./drawing.mjs";

const state = (page) => page.evaluate(() => higherpair.state());

export async function checkControls(page, table, checks) {
  const end = table.rows.length - 1;
  await checkKeys(page, end, checks);
  await checkLayers(page, checks);
  await checkPlots(page, table, checks);
  await page.locator("#play").click();
  checks.true((await state(page)).playing, "does not play");
  // Waits as long as a busy machine takes for the next frame.
  const moves = page.waitForFunction(() => higherpair.state().row > 0);
  checks.true(await moves.then(() => true, () => false), "stands although it plays");
  await page.keyboard.press("Escape");
  await page.locator("#play").click();
  checks.equal((await state(page)).playing, false, "does not pause");
}

async function checkKeys(page, end, checks) {
  await page.locator("#drawing").focus();
  const steps = [["End", end], ["ArrowLeft", end - 1], ["Home", 0], ["ArrowRight", 1], ["ArrowRight", 2]];
  for (const [key, row] of steps) {
    await page.keyboard.press(key);
    checks.equal((await state(page)).row, row, `row after ${key}`);
  }
  await page.keyboard.press("Space");
  checks.equal((await state(page)).playing, true, "space does not play");
  await page.keyboard.press("Space");
  checks.equal((await state(page)).playing, false, "space does not pause");
  await page.keyboard.press("Home");
}

/** The slider moves the drawing to where the table says. */
export async function checkSlider(page, table, checks) {
  const end = table.rows.length - 1;
  const slider = page.locator("#row");
  await slider.fill(String(Math.round(end / 3)));
  checks.equal((await state(page)).row, Math.round(end / 3), "row after the slider");
  await checkRow(page, table, Math.round(end / 3), checks);
  const box = await slider.boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  checks.near((await state(page)).row, end / 2, 0.02 * end + 1, "row after a click on the slider");
  await slider.fill("0");
}

async function checkLayers(page, checks) {
  for (const toggle of await page.locator("#layers button").all()) {
    const role = await toggle.getAttribute("data-layer");
    const isShown = () =>
      page.evaluate((name) => getComputedStyle(document.querySelector(`#drawing [data-role="${name}"]:not(.absent)`) ?? document.querySelector(`#drawing [data-role="${name}"]`)).display !== "none", role);
    const before = (await toggle.getAttribute("aria-pressed")) === "true";
    await toggle.click();
    checks.equal((await toggle.getAttribute("aria-pressed")) === "true", !before, `layer ${role} does not change`);
    if (before) checks.equal(await isShown(), false, `layer ${role} is seen though it is off`);
    await toggle.click();
  }
}

/** The cursor of every plot is where the axis has the row. */
async function checkCursors(page, table, what, checks) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const axis = (await page.locator("#x-axis option:checked").textContent()).replace(/ \[.*/, "");
  const values = table.rows.map((one, row) => (axis === "row" ? row : Number(one[axis])));
  const share = (values[(await state(page)).row] - Math.min(...values)) / (Math.max(...values) - Math.min(...values));
  for (const plot of await page.locator(".plot").all()) {
    const box = await plot.locator(".u-over").boundingBox();
    const cursor = await plot.locator(".cursor-line").boundingBox();
    checks.near(cursor.x - box.x, share * box.width, 3, `cursor after ${what}`);
  }
}

async function checkPlots(page, table, checks) {
  const end = table.rows.length - 1;
  const driver = table.names.find((name) => name.startsWith("driver"));
  const falls = Number(table.rows[end][driver]) < Number(table.rows[0][driver]);
  const plots = page.locator(".plot");
  checks.true((await plots.count()) > 0, "nothing is plotted");
  const over = plots.first().locator(".u-over");
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.click(box.x + box.width * 0.75, box.y + box.height / 2);
  checks.near((await state(page)).row, (falls ? 0.25 : 0.75) * end, 0.02 * end + 1, "row after a click into a plot");
  const cursor = await plots.first().locator(".cursor-line").boundingBox();
  checks.near(cursor.x, box.x + box.width * 0.75, 0.02 * box.width + 2, "cursor of the plot");
  const before = await plots.count();
  await page.locator("#search").fill("driver velocity");
  await page.locator("#value-table tr:not([hidden]) .plot-toggle").first().click();
  checks.equal(await plots.count(), before + 1, "plots after one was added");
  await checkCursors(page, table, "a plot was added", checks);
  const axis = page.locator("#x-axis");
  await axis.selectOption({ index: (await axis.locator("option").count()) - 1 });
  await checkCursors(page, table, "the axis was changed", checks);
  await axis.selectOption({ index: 0 });
  await page.locator("#value-table tr:not([hidden]) .plot-toggle").first().click();
  checks.equal(await plots.count(), before, "plots after it was taken away");
  await page.locator("#search").fill("");
  await page.evaluate(() => scrollTo(0, 0));
  await page.evaluate(() => higherpair.go(0));
}

/** Drags the driven body along its path in the following rows: the mechanism follows. */
export async function checkDrag(page, table, checks) {
  const count = table.rows.length;
  const first = Math.round(count / 30);
  const last = first + Math.max(2, Math.round(count / 25));
  await page.evaluate((row) => higherpair.go(row), first);
  await page.locator("#drawing").scrollIntoViewIfNeeded();
  const grip = await page.evaluate(findGrip);
  checks.true(grip !== null, "there is nothing to drag");
  if (grip === null) return;
  const way = await page.evaluate(wayOf, { grip, first, last });
  await page.mouse.move(grip.x, grip.y);
  await page.mouse.down();
  for (const { x, y } of way) await page.mouse.move(x, y);
  const { row } = await state(page);
  await page.mouse.up();
  // A mouse is at whole pixels, and lags a little towards the rows that it comes from.
  const pixel = way.length / Math.max(grip.reach, 1e-9);
  checks.near(row, last, 3 + 3 * Math.min(pixel, 3), `dragged from row ${first}`);
  checks.true(row > first, "dragging moves nothing");
}

// A point at which the driven body can be grabbed, far from its pivot; in px of the window. Runs in the page.
function findGrip() {
  const { driver } = JSON.parse(document.getElementById("report-data").textContent);
  const drawing = document.getElementById("drawing");
  const frame = drawing.querySelector(`[data-frame="${driver.body}"]`);
  const origin = new DOMPoint(0, 0).matrixTransform(frame.getScreenCTM());
  const box = drawing.getBoundingClientRect();
  let found = null;
  for (let x = box.left + 3; x < box.right; x += 6) {
    for (let y = Math.max(box.top, 0) + 3; y < Math.min(box.bottom, innerHeight); y += 6) {
      const reach = Math.hypot(x - origin.x, y - origin.y);
      if (found !== null && reach < found.reach) continue;
      const parts = document.elementsFromPoint(x, y);
      if (parts[0]?.closest("#drawing") === null) continue;
      if (parts.some((part) => part.getAttribute("data-body") === String(driver.body))) found = { x, y, reach };
    }
  }
  return found;
}

// Where that point of the body is drawn in the following rows. Runs in the page.
function wayOf({ grip, first, last }) {
  const { driver } = JSON.parse(document.getElementById("report-data").textContent);
  const frame = document.querySelector(`#drawing [data-frame="${driver.body}"]`);
  const held = new DOMPoint(grip.x, grip.y).matrixTransform(frame.getScreenCTM().inverse());
  const way = [];
  for (let row = first + 1; row <= last; ++row) {
    higherpair.go(row);
    const { x, y } = held.matrixTransform(frame.getScreenCTM());
    way.push({ x, y });
  }
  higherpair.go(first);
  return way;
}

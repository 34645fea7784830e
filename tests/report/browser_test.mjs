// Every shipped profile's report in a real browser: it writes nothing to the console and makes no network
// requests, what it draws agrees with the table of `analyze`, and its controls move it.
//   node browser_test.mjs PROGRAM PROFILES PAGE_FOLDER OUTPUT_FOLDER [PROFILE …]
import { execFile, execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, rmSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { cpus } from "node:os";
import { basename, join } from "node:path";
import { pathToFileURL } from "node:url";
import { Checks, parseCsv } from "./checks.mjs";
import { checkControls, checkDrag, checkSlider } from "./controls.mjs";
import { checkBrokenLinks, checkDrawing, checkHollow } from "./drawing.mjs";
import { checkFigures } from "./figures.mjs";
import {
  checkAxes, checkCards, checkFrames, checkLongRun, checkLooks, checkPrint, checkSaving, checkSizes, checkTitle, checkWords,
} from "./special.mjs";

const SKIPPED = 77; // exit code for ctest
const LARGEST_PAGE = 2 * 1024 * 1024;
/** All controls, dark mode and the size of a phone are tried on these, which are of different kinds. */
const LOOKED_AT_CLOSELY = [
  "ellipse_cam_roller", "lock_up", "slider_crank", "five_bar", "watt_sixbar_forces", "flat_faced_translating", "planetary_gear",
];
const [program, profiles, pageFolder, output, ...wanted] = process.argv.slice(2);
const reports = join(output, "reports of profiles"); // the space tests that paths may contain one
const screens = join(output, "screens");

function findBrowser() {
  for (const name of ["chromium", "chromium-browser", "google-chrome"]) {
    try {
      return execFileSync("which", [name], { encoding: "utf8" }).trim();
    } catch {
      // try the next one
    }
  }
  console.log("skipped: there is no chromium here; tools/setup installs it");
  process.exit(SKIPPED);
}

/** Runs the program; any exit code other than the given ones is an error. */
function run(args, codes = [0]) {
  return new Promise((done, fail) => {
    execFile(program, args, { encoding: "utf8", maxBuffer: 1 << 28 }, (error, stdout) => {
      if (error === null || codes.includes(error.code)) done(stdout);
      else fail(error);
    });
  });
}

async function report(profile, name, ...options) {
  const file = join(reports, `${name}.html`);
  await run(["report", profile, "-o", file, "--quiet", ...options], [0, 4]);
  return file;
}

/** Until the page is laid out and has adapted to its size and colours, one frame after a change. */
const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));

/** A page that reports its own errors as failures. */
async function open(context, file, checks) {
  const page = await context.newPage();
  const url = pathToFileURL(file).href;
  page.on("console", (message) => checks.true(false, `console: ${message.text()}`));
  page.on("pageerror", (error) => checks.true(false, `error: ${error.message}`));
  page.on("request", (request) => {
    const local = request.url() === url || request.url().startsWith("blob:") || request.url().startsWith("data:");
    checks.true(local, `request of ${request.url()}`);
  });
  await page.goto(url);
  await drawn(page);
  return page;
}

/** Of the background. */
const luminance = (page) =>
  page.evaluate(() => {
    const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
    return (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
  });

async function checkDarkAndPhone(page, name, checks) {
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  await drawn(page);
  checks.true((await luminance(page)) < 0.2, "dark is not dark");
  await page.screenshot({ path: join(screens, `${name}-dark.png`) });
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  await page.setViewportSize({ width: 375, height: 740 });
  await drawn(page);
  const widths = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  checks.true(widths[0] <= widths[1], `wider than a phone: ${widths}`);
  await page.screenshot({ path: join(screens, `${name}-phone.png`) });
}

async function checkProfile(context, name, made, checks) {
  const { html, table } = await made;
  checks.true(statSync(html).size < LARGEST_PAGE, "the page is 2 MiB or more");
  const page = await open(context, html, checks);
  checks.equal(await page.evaluate(() => higherpair.state().playing), false, "plays although motion is reduced");
  checks.equal(await page.evaluate(() => higherpair.rows.length), table.rows.length, "rows");
  checks.true((await luminance(page)) > 0.8, "light is not light");
  await checkDrawing(page, table, checks);
  await checkFigures(page, table, checks);
  if (name === "parabola_cam") await checkBrokenLinks(page, table, 20, checks);
  if (name === "oval_in_ring") await checkHollow(page, checks);
  await checkSlider(page, table, checks);
  if (LOOKED_AT_CLOSELY.includes(name)) {
    await page.screenshot({ path: join(screens, `${name}.png`), fullPage: true });
    await page.bringToFront();
    await checkControls(page, table, checks);
    await checkDrag(page, table, checks);
    await checkDarkAndPhone(page, name, checks);
  }
  await page.close();
}

/** Makes report and table of each profile, as many at a time as there are processors. */
function makeAll(names) {
  const waiting = new Map(names.map((name) => [name, withResolvers()]));
  const queue = [...names];
  const work = async () => {
    for (let name = queue.shift(); name !== undefined; name = queue.shift()) {
      const profile = join(profiles, `${name}.toml`);
      try {
        const html = await report(profile, name);
        const table = parseCsv(await run(["analyze", profile, "--quiet"], [0, 4]));
        waiting.get(name).resolve({ html, table });
      } catch (error) {
        waiting.get(name).reject(error);
      }
    }
  };
  cpus().forEach(work);
  return waiting;
}

function withResolvers() {
  const made = {};
  made.promise = new Promise((resolve, reject) => Object.assign(made, { resolve, reject }));
  made.promise.catch(() => {}); // whoever awaits it sees the error
  return made;
}

const executablePath = findBrowser();
const { chromium } = createRequire(join(pageFolder, "package.json"))("playwright-core");
for (const folder of [reports, screens]) mkdirSync(folder, { recursive: true });
const userData = join(output, "browser");
rmSync(userData, { recursive: true, force: true });
const names = readdirSync(profiles)
  .filter((file) => file.endsWith(".toml"))
  .map((file) => basename(file, ".toml"))
  .filter((name) => wanted.length === 0 || wanted.includes(name))
  .sort();
const made = makeAll(names);
const context = await chromium.launchPersistentContext(userData, {
  executablePath,
  headless: true,
  viewport: { width: 1440, height: 900 },
  reducedMotion: "reduce",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
    // One process draws all pages, one after another: starting one for each takes longer than many a page.
    "--renderer-process-limit=1", "--disable-site-isolation-trials"],
});
const all = [];
try {
  for (const name of names) {
    const checks = new Checks(name);
    all.push(checks);
    const began = performance.now();
    await checkProfile(context, name, made.get(name).promise, checks);
    console.log(`${name}: ${((performance.now() - began) / 1000).toFixed(1)} s`);
  }
  const special = new Checks("special");
  all.push(special);
  const tools = { report, profiles, output: reports, open: (file) => open(context, file, special) };
  const single = [
    checkTitle, checkCards, checkWords, checkLooks, checkPrint, checkAxes, checkSizes, checkLongRun, checkSaving, checkFrames,
  ];
  for (const check of single) await check(tools, special);
} finally {
  await context.close();
}
const failures = all.flatMap((checks) => checks.failures);
console.log([...failures, `${all.reduce((sum, checks) => sum + checks.count, 0)} checks, ${failures.length} failed`].join("\n"));
process.exit(failures.length === 0 ? 0 : 1);

// Every shipped profile's report in a real browser: it says nothing on the console and asks nothing of the network,
// what it draws is where the table of `analyze` says, and all of its controls move it.
//   node browser_test.mjs PROGRAM PROFILES PAGE_FOLDER OUTPUT_FOLDER [PROFILE …]
import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, rmSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { checkControls, checkDrag } from "./controls.mjs";
import { checkDrawing } from "./drawing.mjs";
import { Checks, parseCsv } from "./checks.mjs";
import { checkLongRun, checkSaving, checkTitle } from "./special.mjs";

const SKIPPED = 77; // of ctest
const LARGEST_PAGE = 2 * 1024 * 1024;
const [program, profiles, pageFolder, output, ...wanted] = process.argv.slice(2);
const reports = join(output, "reports of profiles"); // names with spaces are names
const screens = join(output, "screens");

function findBrowser() {
  for (const name of ["chromium", "chromium-browser", "google-chrome"]) {
    try {
      return execFileSync("which", [name], { encoding: "utf8" }).trim();
    } catch {
      // the next one
    }
  }
  console.log("skipped: there is no chromium here; tools/setup installs it");
  process.exit(SKIPPED);
}

/** Runs the program; any exit code but those is an error. */
function run(args, codes = [0]) {
  try {
    return execFileSync(program, args, { encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] });
  } catch (error) {
    if (codes.includes(error.status)) return error.stdout;
    throw error;
  }
}

function report(profile, name, ...options) {
  const file = join(reports, `${name}.html`);
  run(["report", profile, "-o", file, "--quiet", ...options], [0, 4]);
  return file;
}

/** A page that watches itself: what goes wrong in it is a failure. */
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
  return page;
}

async function checkSizesAndColours(page, name, checks) {
  const luminance = () =>
    page.evaluate(() => {
      const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
      return (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
    });
  checks.true((await luminance()) > 0.8, "light is not light");
  await page.screenshot({ path: join(screens, `${name}.png`), fullPage: true });
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  checks.true((await luminance()) < 0.2, "dark is not dark");
  await page.screenshot({ path: join(screens, `${name}-dark.png`) });
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  await page.setViewportSize({ width: 375, height: 740 });
  const widths = await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => setTimeout(() => done([document.documentElement.scrollWidth, innerWidth])))),
  );
  checks.true(widths[0] <= widths[1], `wider than a phone: ${widths}`);
  await page.screenshot({ path: join(screens, `${name}-phone.png`) });
}

async function checkProfile(context, file, checks) {
  const name = file.replace(/\.toml$/, "");
  const profile = join(profiles, file);
  const html = report(profile, name);
  checks.true(statSync(html).size < LARGEST_PAGE, "the page is 2 MiB or more");
  const table = parseCsv(run(["analyze", profile, "--quiet"], [0, 4]));
  const page = await open(context, html, checks);
  checks.equal(await page.evaluate(() => higherpair.state().playing), false, "plays although motion is reduced");
  checks.equal(await page.evaluate(() => higherpair.rows.length), table.rows.length, "rows");
  await checkDrawing(page, table, checks);
  await checkControls(page, table, checks);
  await checkDrag(page, table, checks);
  await page.evaluate((row) => higherpair.go(row), Math.round(0.15 * table.rows.length));
  await checkSizesAndColours(page, name, checks);
  await page.close();
}

const executablePath = findBrowser();
const { chromium } = createRequire(join(pageFolder, "package.json"))("playwright-core");
for (const folder of [reports, screens]) mkdirSync(folder, { recursive: true });
const userData = join(output, "browser");
rmSync(userData, { recursive: true, force: true });
const context = await chromium.launchPersistentContext(userData, {
  executablePath,
  headless: true,
  viewport: { width: 1440, height: 900 },
  reducedMotion: "reduce",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"],
});
const all = [];
try {
  for (const file of readdirSync(profiles).filter((one) => one.endsWith(".toml")).sort()) {
    if (wanted.length > 0 && !wanted.includes(file.replace(/\.toml$/, ""))) continue;
    const checks = new Checks(file);
    all.push(checks);
    await checkProfile(context, file, checks);
  }
  const special = new Checks("special");
  all.push(special);
  const tools = { report, profiles, open: (file) => open(context, file, special) };
  await checkTitle(tools, special);
  await checkLongRun(tools, special);
  await checkSaving(tools, special);
} finally {
  await context.close();
}
const failures = all.flatMap((checks) => checks.failures);
console.log([...failures, `${all.reduce((sum, checks) => sum + checks.count, 0)} checks, ${failures.length} failed`].join("\n"));
process.exit(failures.length === 0 ? 0 : 1);

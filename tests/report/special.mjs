// Single properties for which one report is enough.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

/** A title that looks like a script is shown as text. */
export async function checkTitle({ report, profiles, open }, checks) {
  const title = `<script>document.body.remove()</script></script><!--<script> & "quoted" \\ é`;
  const toml = `title=${JSON.stringify(title)}`;
  const page = await open(await report(join(profiles, "knife_edge.toml"), "title", "--set", toml));
  checks.equal(await page.locator("h1").textContent(), title, "title");
  checks.equal(await page.title(), title, "title of the window");
  checks.true((await page.locator("#source").textContent()).includes("--set title="), "the foot does not show --set");
  await page.close();
}

/** Nothing in the cards at the top leaves its card, and speeds there have no sign. */
export async function checkCards({ report, profiles, open }, checks) {
  const page = await open(await report(join(profiles, "valve_train.toml"), "cards"));
  for (const width of [375, 800, 1024, 1280, 1350, 1400, 1600, 1920, 2560]) {
    await page.setViewportSize({ width, height: 800 });
    const wide = await page.evaluate(() =>
      [...document.querySelectorAll(".card")].filter((card) => card.scrollWidth > card.clientWidth).map((card) => card.textContent),
    );
    checks.equal(wide.join(), "", `cards that overflow at ${width} px`);
  }
  const speeds = await page.locator(".card dt:text-is('Max. speed') + dd").allTextContents();
  checks.true(speeds.length > 0 && speeds.every((text) => !text.includes("−")), `speeds with a sign: ${speeds}`);
  await page.close();
}

/** What turns right round does not swing, what rolls does not slide, and a driver that stands still tells no place. */
export async function checkWords({ report, profiles, open }, checks) {
  const cards = async (name) => {
    const page = await open(await report(join(profiles, `${name}.toml`), `words of ${name}`));
    const texts = await page.locator(".card").allTextContents();
    await page.close();
    return texts.join(" ");
  };
  const belt = await cards("belt_drive");
  checks.true(belt.includes("Turns") && !belt.includes("Swing"), `a pulley that turns: ${belt}`);
  const rolling = await cards("rolling_ellipses");
  checks.true(!rolling.includes("sliding"), `a contact that rolls: ${rolling}`);
  const arch = await cards("design_arch_path");
  checks.true(arch.includes("row 1"), `places of a driver that stands still: ${arch}`);
}

/** On paper nothing scrolls, and nothing is there that can only be clicked. */
export async function checkPrint({ report, profiles, open }, checks) {
  const page = await open(await report(join(profiles, "oval_in_ring.toml"), "print"));
  await page.emulateMedia({ media: "print" });
  const cut = await page.evaluate(() =>
    [...document.querySelectorAll(".scroll, .events")]
      .filter((box) => box.clientHeight > 0 && box.scrollHeight > box.clientHeight + 1)
      .map((box) => box.ariaLabel),
  );
  checks.equal(cut.join(), "", "boxes that are cut off on paper");
  const seen = await page.evaluate(() =>
    [...document.querySelectorAll("button:not(.where), input, select")]
      .filter((control) => control.checkVisibility())
      .map((control) => control.id || control.className),
  );
  checks.equal([...new Set(seen)].join(), "", "controls on paper");
  await page.close();
}

/** Of two axes of y each has the colour of its line, and 0 at the same height. */
export async function checkAxes({ report, profiles, open }, checks) {
  const page = await open(await report(join(profiles, "sixbar_slider.toml"), "axes"));
  const coloured = await page.evaluate(async () => {
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const plot = [...document.querySelectorAll(".plot")].find((one) => one.querySelectorAll(".chip").length === 2);
    const canvas = plot.querySelector("canvas");
    const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height })
      .getContext("2d", { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const [box, over] = [canvas.getBoundingClientRect(), plot.querySelector(".u-over").getBoundingClientRect()];
    const beside = (left, right) => {
      const { data } = copy.getImageData(left * devicePixelRatio, 0, (right - left) * devicePixelRatio, canvas.height);
      return data.some((_, i) => {
        if (i % 4 !== 0 || data[i + 3] < 128) return false;
        const [r, g, b] = data.slice(i, i + 3);
        return Math.max(r, g, b) - Math.min(r, g, b) > 80;
      });
    };
    return [beside(0, over.left - box.left - 4), beside(over.right - box.left + 4, box.width)];
  });
  checks.equal(coloured.join(), "true,true", "coloured figures at both axes");
  const ranges = await page.evaluate(() => [...document.querySelectorAll(".plot .canvas")].map((one) => JSON.parse(one.dataset.ranges)));
  const pairs = ranges.filter((found) => found.length === 2);
  checks.true(pairs.length > 0, "no plot has two axes");
  for (const [[a, b], [c, d]] of pairs) checks.near(-a / (b - a), -c / (d - c), 1e-9, "height of 0 on the second axis");
  await page.close();
}

/** A colour of the profile fills the body, whose lines stay as they are. */
export async function checkLooks({ report, profiles, open }, checks) {
  const page = await open(await report(join(profiles, "ellipse_cam_roller.toml"), "looks", "--set", 'drawing.cam.colour="#f6d8a8"'));
  const styles = await page.evaluate(() => {
    const style = (selector) => getComputedStyle(document.querySelector(selector));
    const [cam, other] = [style('#drawing [data-role="body"][data-name="cam"]'), style('#drawing [data-role="joint"]')];
    return { fill: cam.fill, opacity: cam.fillOpacity, line: cam.stroke, ink: other.stroke };
  });
  checks.equal(styles.fill, "rgb(246, 216, 168)", "fill of the cam");
  checks.equal(styles.opacity, "1", "opacity of the fill");
  checks.equal(styles.line, styles.ink, "line of the cam");
  await page.close();
}

/** A four-bar whose lengths are this many times some millimetres. */
const fourBar = (size) => `
bodies.ground.points = { O2 = [0, 0], O4 = [${40 * size}, 0] }
bodies.crank = { pose.angle = 60, points = { O2 = [0, 0], A = [${10 * size}, 0] } }
bodies.coupler = { pose.angle = 30, points = { A = [0, 0], B = [${35 * size}, 0], E = [${20 * size}, ${10 * size}] } }
bodies.rocker = { pose = { x = ${40 * size}, angle = 100 }, points = { O4 = [0, 0], B = [${25 * size}, 0] } }
joints.O2 = { type = "revolute", between = ["ground.O2", "crank.O2"] }
joints.A = { type = "revolute", between = ["crank.A", "coupler.A"] }
joints.B = { type = "revolute", between = ["coupler.B", "rocker.B"] }
joints.O4 = { type = "revolute", between = ["ground.O4", "rocker.O4"] }
driver = { joint = "O2", start = 60, end = 420, samples = 91 }
`;

/** A mechanism of a few nanometres or kilometres is drawn as one of some centimetres. */
export async function checkSizes({ report, output, open }, checks) {
  const drawn = [];
  for (const size of [1, 1e-7, 1e6]) {
    const file = join(output, `four_bar_${size}.toml`);
    writeFileSync(file, fourBar(size));
    const page = await open(await report(file, `size ${size}`));
    drawn.push(await page.evaluate(() => {
      const picture = document.getElementById("drawing").getBoundingClientRect(); // what is above it may be higher
      return [...document.querySelectorAll("#drawing path, #drawing circle, #drawing text")].map((shape) => {
        const box = shape.getBoundingClientRect();
        return [shape.dataset.name, box.left - picture.left, box.top - picture.top, box.width, box.height];
      });
    }));
    await page.close();
  }
  const [usual, ...others] = drawn;
  for (const other of others) {
    checks.equal(other.length, usual.length, "shapes of another size");
    const moved = usual.filter((shape, i) => shape.some((value, k) => k > 0 && !(Math.abs(value - other[i][k]) < 0.5)));
    const first = usual.indexOf(moved[0]);
    checks.equal(moved.map(([name]) => name).join(), "", `shapes that are drawn elsewhere in another size, such as ${usual[first]} at ${other[first]}`);
  }
}

/** The page of a long run contains part of it, says so, and knows the extremes of the whole run. */
export async function checkLongRun({ report, profiles, open }, checks) {
  const page = await open(await report(join(profiles, "knife_edge.toml"), "long run", "--samples", "100001"));
  const rows = await page.evaluate(() => higherpair.rows.length);
  checks.true(rows > 700 && rows <= 1441, `${rows} rows of a long run`);
  const subtitle = await page.locator("#subtitle").textContent();
  checks.true(subtitle.includes("of 100001 rows"), `the page does not say that it is thinned: ${subtitle}`);
  const ends = await page.evaluate(() => [higherpair.rows[0][0], higherpair.rows[higherpair.rows.length - 1][0]]);
  checks.equal(ends.join(), "0,360", "ends of the thinned run");
  await page.close();
}

/** How long frames take while the motion plays with forces on; only printed, since it depends on the machine. */
export async function checkFrames({ report, profiles, open }, checks) {
  const page = await open(await report(join(profiles, "watt_sixbar_forces.toml"), "frames"));
  const painted = await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime);
  const seconds = 2;
  const { gaps, busy } = await page.evaluate(framesOf, 1000 * seconds);
  const sorted = [...gaps].sort((a, b) => a - b);
  const at = (share) => sorted[Math.floor(share * (sorted.length - 1))]?.toFixed(1);
  checks.true(gaps.length > 1, "no frame while it plays");
  console.log(
    `frames of the six-bar with forces: ${(gaps.length / seconds).toFixed(0)} a second, median ${at(0.5)} ms, 95 % within ${at(0.95)} ms; ` +
      `a row is set in ${busy.toFixed(2)} ms; first picture after ${painted?.toFixed(0)} ms`,
  );
  await page.close();
}

async function saved(page, button) {
  const waiting = page.waitForEvent("download");
  await page.locator(button).click();
  const download = await waiting;
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
}

/** Frame and table as files; plots over time; a page that plays by itself. */
export async function checkSaving({ report, profiles, open }, checks) {
  const page = await open(await report(join(profiles, "eccentric_disc_oscillating_roller.toml"), "in time", "--time"));
  const table = await saved(page, "#save-csv");
  checks.equal(table.name, "eccentric_disc_oscillating_roller.csv", "name of the table");
  checks.true(table.text.startsWith("time[s],driver[deg],"), "head of the table");
  checks.equal(table.text.trimEnd().split("\n").length, 602, "lines of the table");
  const picture = await saved(page, "#save-svg");
  const read = await page.evaluate((text) => {
    const svg = new DOMParser().parseFromString(text, "image/svg+xml");
    const point = svg.querySelector('[data-role="contact"]');
    const root = svg.documentElement;
    const [ox] = root.getAttribute("data-origin").split(" ").map(Number);
    return { error: svg.querySelector("parsererror") !== null, x: point?.getAttribute("cx"), ox, hidden: svg.querySelector('[data-role="velocity"]') !== null };
  }, picture.text);
  checks.equal(read.error, false, "the saved frame is no XML");
  const drawn = await page.evaluate(() => higherpair.state().contacts.touch[0]);
  checks.near(Number(read.x), drawn, 1e-9, "contact in the saved frame");
  checks.equal(read.hidden, false, "the saved frame holds what is not seen");
  await page.locator("#x-axis").selectOption({ label: "time [s]" });
  checks.true((await page.locator("#place").textContent()).startsWith("time 0 s"), "time is not shown");
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.reload();
  checks.equal(await page.evaluate(() => higherpair.state().playing), true, "does not play by itself");
  await page.close();
}

// Times between frames while it plays [ms], and the time that the page needs for a row, including layout.
// Runs in the page.
async function framesOf(length) {
  const slow = 60;
  const began = performance.now();
  for (let row = 0; row < slow; ++row) {
    higherpair.go(3 * row);
    document.body.getBoundingClientRect();
  }
  const busy = (performance.now() - began) / slow;
  document.getElementById("play").click();
  const gaps = [];
  await new Promise((done) => {
    const first = performance.now();
    let last = first;
    const frame = (now) => {
      gaps.push(now - last);
      last = now;
      if (now - first < length) requestAnimationFrame(frame);
      else done();
    };
    requestAnimationFrame(frame);
  });
  document.getElementById("play").click();
  return { gaps, busy };
}

// Bundles the page of reports into one file: node build.mjs OUTPUT.html
import { readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const output = process.argv[2];
if (output === undefined) {
  console.error("usage: node build.mjs OUTPUT.html");
  process.exit(2);
}

async function bundle(entry) {
  const result = await build({
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2020",
    charset: "utf8",
    legalComments: "none",
  });
  return result.outputFiles[0].text.trim();
}

const page = await readFile("src/page.html", "utf8");
const style = (await bundle("src/style.css")).replaceAll("</", "<\\/");
const script = (await bundle("src/main.ts")).replaceAll("</script", "<\\/script");
// Functions: in a text of replacement `$&` would mean something.
await writeFile(output, page.replace("/*STYLE*/", () => style).replace("/*SCRIPT*/", () => script));

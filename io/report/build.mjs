// Bundles the page's program and style into dist/, with the licences of what is in them.
// `npm ci && npm run build`, or `node build.mjs FOLDER` for another place (the test compares).
import { buildSync } from "esbuild";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "dist");

mkdirSync(out, { recursive: true });
buildSync({
  absWorkingDir: here,
  entryPoints: { report: "src/main.js" },
  outdir: out,
  bundle: true,
  minify: true,
  charset: "ascii", // whatever the page around it is read as
  legalComments: "none", // whole licences are in licences.txt
  format: "iife",
  target: "es2022",
  logLevel: "warning",
});

// Nothing in the program may end the element that it stands in.
const program = join(out, "report.js");
const text = readFileSync(program, "utf8");
writeFileSync(program, text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--"));

const licences = ["three", "uplot"].map((name) => {
  const folder = join(here, "node_modules", name);
  const { version } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  return `${name} ${version}\n\n${readFileSync(join(folder, "LICENSE"), "utf8").trim()}\n`;
});
writeFileSync(join(out, "licences.txt"), licences.join(`\n${"-".repeat(72)}\n\n`));

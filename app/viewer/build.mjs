// Builds built/replay.js from src/. With --compare nothing is written: exit 1 if the committed
// script is not what the sources give.
import {build} from "esbuild";
import {readFileSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "built", "replay.js");
const result = await build({
  entryPoints: [join(here, "src", "main.ts")],
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2021"],
  charset: "ascii",
  lineLimit: 400,  // the script becomes string literals of a C++ file, cut at line ends
  legalComments: "none",
  write: false,
  absWorkingDir: here,
});

const licence = name => {
  const text = readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim();
  const {version} = JSON.parse(readFileSync(join(here, "node_modules", name, "package.json"), "utf8"));
  return `${name} ${version}\n\n${text}`;
};
const head = "/*\nContains parts of these packages, under their licences:\n\n" +
  ["three", "uplot", "fflate"].map(licence).join("\n\n") + "\n*/\n";
// No address of any kind in the page: it must not even look as if it loaded something.
const script = head + result.outputFiles[0].text;
// After a comment mark of HTML, which it has, the word behind the second one would hide its end.
for (const word of ["</script", "<script"]) if (script.includes(word)) throw new Error(`the script must not hold ${word}`);

if (process.argv.includes("--compare")) {
  if (readFileSync(out, "utf8") !== script) {
    console.error("built/replay.js is not what src/ gives: run `npm run build` in app/viewer");
    process.exit(1);
  }
  console.log("built/replay.js is up to date");
} else {
  writeFileSync(out, script);
  console.log(`built/replay.js: ${(script.length / 1e3).toFixed(0)} kB`);
}

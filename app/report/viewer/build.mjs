// Makes the script of the interactive view: node build.mjs OUTPUT. Its first line holds the hash that lets a browser run
// the rest of it and nothing else; the licence of what is inside comes next.
import {createHash} from "node:crypto";
import {readFileSync, renameSync, writeFileSync} from "node:fs";
import {build} from "esbuild";

const output = process.argv[2];
const {version} = JSON.parse(readFileSync("node_modules/three/package.json", "utf8"));
const licence = readFileSync("node_modules/three/LICENSE", "utf8").trim();
const made = await build({entryPoints: ["viewer.js"], bundle: true, minify: true, format: "iife", target: "es2020",
  legalComments: "none", charset: "ascii", write: false});
const script = `/* Contains three.js ${version}:\n\n${licence}\n*/\n${made.outputFiles[0].text}`;
if (/<\/script|<!--/i.test(script)) throw new Error("the script holds what would end it in a page");
const hash = createHash("sha256").update(script).digest("base64");
writeFileSync(`${output}.part`, `sha256-${hash}\n${script}`);
renameSync(`${output}.part`, output);

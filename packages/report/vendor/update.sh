#!/usr/bin/env bash
# Makes libraries.min.js from the versions that package.json names, with the licence of each library that went in. Needs npm;
# a build of Toile does not.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cp "$here/package.json" "$here/entry.js" "$work"
cd "$work"
npm install --no-audit --no-fund --silent
npx esbuild entry.js --bundle --minify --format=iife --global-name=libraries --legal-comments=none --charset=ascii \
  --metafile=parts.json --outfile=bundle.js --log-level=warning

# A library is named once, by the folder that its files lie in.
node -e '
  const fs = require("fs"), { inputs } = Object.values(require("./parts.json").outputs)[0];
  const folder = (file) => (/^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file) || [])[1];
  const used = Object.entries(inputs).filter(([, part]) => part.bytesInOutput > 0).map(([file]) => folder(file));
  for (const name of [...new Set(used.filter(Boolean))].sort()) {
    const { version, license } = require(`./node_modules/${name}/package.json`);
    const file = fs.readdirSync(`node_modules/${name}`).find((one) => /^licen[cs]e/i.test(one));
    if (!file) throw new Error(`${name} has no licence`);
    console.log(`${name} ${version}, ${license}\n\n${fs.readFileSync(`node_modules/${name}/${file}`, "utf8").trim()}\n`);
  }' >licences.txt
cp licences.txt "$here/LICENCES.txt"
# A comment that no minifier and no reader of the page can miss. "</script" would end the element that the page puts this in.
{ printf '/*!\n'; sed 's|\*/|* /|g' licences.txt; printf '*/\n'; cat bundle.js; } | sed 's|</script|<\\/script|g' >"$here/libraries.min.js"

// Prints what there is to choose from, as JSON for a page:
//   node choices.js engine.js data
// {"pairs": [{"file", "text"}], "backings": ..., "joints": ...} and what the
// engine says.
'use strict';
const fs = require('fs');
const path = require('path');

const [engine, data] = process.argv.slice(2).map((each) => path.resolve(each));

const files = (folder) => fs.readdirSync(path.join(data, folder))
    .filter((file) => file.endsWith('.toml')).sort()
    .map((file) => (
      {file, text: fs.readFileSync(path.join(data, folder, file), 'utf8')}));

async function main() {
  const {ccall} = await require(engine)(
      {wasmBinary: fs.readFileSync(engine.replace(/js$/, 'wasm'))});
  const all = {
    pairs: files('materials'), backings: files('backings'),
    joints: files('joints'),
    ...JSON.parse(ccall('page_choices', 'string', [], [])),
  };
  process.stdout.write(JSON.stringify(all).replaceAll('<', '\\u003c'));
}
main();

#!/usr/bin/env node
// Writes the package as one classic script, which a page that is opened from a
// disk may load: npx libcontact-global > libcontact.global.js
import {readFileSync} from 'node:fs';
import {gzipSync} from 'node:zlib';

const file = (name) => readFileSync(new URL(name, import.meta.url));
const code = ['toml', 'memory', 'quantities', 'joint', 'mechanism', 'index']
    .map((name) => String(file(`${name}.js`)))
    .join('').replace(/^import .*$|^export \{.*$/gm, '')
    .replace(/^export /gm, '').replace('import.meta.url', 'location');
const packed = gzipSync(file('contact.wasm'), {level: 9}).toString('base64');
process.stdout.write(`var libcontact = (() => {
'use strict';
${code}
async function unpacked() {
  const bytes = Uint8Array.from(atob('${packed}'), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream()
      .pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
return {ContactError, load: async (source) => load(source ?? await unpacked())};
})();
`);

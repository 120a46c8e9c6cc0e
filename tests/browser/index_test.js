// The page that scripts/demo_index.sh makes of what was run, in a real browser.
'use strict';
const assert = require('assert');
const {execFileSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {test} = require('node:test');
const {withPage} = require('./chromium.js');

const script = path.resolve(__dirname, '../../scripts/demo_index.sh');
const svg = '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="30"/>';

test('pictures, files and commands are on the page', async () => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'demo-'));
  const write = (name, text) => fs.writeFileSync(path.join(folder, name), text);
  try {
    fs.mkdirSync(path.join(folder, 'out/figures'), {recursive: true});
    for (const name of ['a.svg', 'many_1.svg', 'many_2.svg', 'figures/b.svg']) {
      write(`out/${name}`, svg);
    }
    write('out/a.csv', 'x\n1\n');
    write('out/said.md', 'text\n');
    write('commands', `# Curves
hinge-angle --load <1&2> --output out/a.csv --plot=out/a.svg
hinge-study s.toml --plot=out/many.svg
figures.sh build out/figures
`);
    execFileSync(script, ['out', 'commands'], {cwd: folder});
    await withPage(path.join(folder, 'out/index.html'), {}, async (page) => {
      const seen = await page.evaluate(async () => {
        const images = [...document.images];
        for (const image of images) {
          image.loading = 'eager';
          await image.decode();
        }
        return {
          images: images.map((image) => image.getAttribute('src')),
          links: [...document.links].map((link) => link.getAttribute('href')),
          command: document.querySelector('pre').textContent,
        };
      });
      assert.deepStrictEqual(seen.images,
          ['a.svg', 'many_1.svg', 'many_2.svg', 'figures/b.svg']);
      for (const link of [...seen.images, 'a.csv', 'said.md']) {
        assert.ok(seen.links.includes(link), link);
      }
      assert.match(seen.command, /--load <1&2> --output out\/a.csv/);
    });
  } finally {
    fs.rmSync(folder, {recursive: true});
  }
});

// The npm package in Chromium: as a classic script of a page from a disk, and as
// a module over http.
//   CONTACT_NPM  the package's folder
'use strict';
const assert = require('node:assert');
const {execFileSync} = require('node:child_process');
const fs = require('node:fs');
const http = require('node:http');
const os = require('node:os');
const path = require('node:path');
const {test} = require('node:test');
const {withPage} = require('../browser/chromium.js');

const folder = path.resolve(process.env.CONTACT_NPM);
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'npm-'));
process.on('exit', () => fs.rmSync(work, {recursive: true}));

// Half-angle of a ball, by a library's Joint.
const halfAngle = ({Joint}) => {
  const steel = {youngs_modulus_GPa: 200, poissons_ratio: 0.3};
  return new Joint({
    kind: 'ball', geometry: {radius_mm: 20, radial_clearance_um: 20},
    materials: {inner: steel, outer: steel}, friction: {coefficient: 0.1},
  }).solve([0, 0, 1000], [1, 0, 0]).half_angle;
};
const file = path.join(work, 'page.html');

test('a page from a disk has it by a classic script', async (t) => {
  const script = execFileSync(process.execPath, [path.join(folder, 'global.js')],
                              {maxBuffer: 1e8, encoding: 'utf8'});
  assert.ok(!script.includes('</script'));
  fs.writeFileSync(file, `<!DOCTYPE html><meta charset="utf-8">
      <link rel="icon" href="data:,"><script>${script}</script>
      <script>const halfAngle = ${halfAngle};</script>`);
  const [theta, ms] = await withPage(file, {}, async (page, said) => {
    const answer = await page.evaluate(async () => {
      const begin = performance.now();
      return [halfAngle(await libcontact.load()), performance.now() - begin];
    });
    assert.deepStrictEqual(said, []);
    return answer;
  });
  t.diagnostic(`${(script.length / 1e6).toFixed(2)} MB, loaded in ${ms.toFixed(0)} ms`);
  assert.ok(theta > 0.1 && theta < 1.5, `${theta}`);
});

test('a module over http has the same number', async (t) => {
  const types = {'.js': 'text/javascript', '.wasm': 'application/wasm'};
  const server = http.createServer(({url}, answer) => {
    const name = path.join(folder, path.normalize(url));
    const type = types[path.extname(name)];
    answer.writeHead(200, {'content-type': type ?? 'text/html'});
    answer.end(type ? fs.readFileSync(name) : '<!DOCTYPE html>');
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  t.after(() => server.close());
  fs.writeFileSync(file, '<!DOCTYPE html>');
  const theta = await withPage(file, {}, async (page) => {
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    return page.evaluate(`(async () => (${halfAngle})(
        await (await import('/index.js')).load()))()`);
  });
  const {load} = await import(path.join(folder, 'index.js'));
  assert.strictEqual(theta, halfAngle(await load()));
});

// The report of a study of hinge-study in a real browser: the page and the
// replays of the worst runs beside it.
'use strict';
const assert = require('assert');
const {execFileSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {test} = require('node:test');
const {fileURLToPath} = require('url');
const {withPage} = require('./chromium.js');

const program = path.resolve(process.env.CONTACT_BUILD, 'bin/hinge-study');
const studies = path.resolve(__dirname, '../../data/studies');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'reports-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true}));
const file = (name) => path.join(folder, name);

// A name that would end an attribute or an address.
const name = 'a "#% é.html';
const report = JSON.parse(execFileSync(
    program, [path.join(studies, 'soyuz.toml'), '--runs', '40', '--report',
              name, '--output', '-'], {cwd: folder}));
const worst = report.requirements.map(({worst: runs}) => runs);

test('a report has tables and pictures and asks for nothing', async () => {
  for (const [colorScheme, width] of
      [['light', 1280], ['dark', 1280], ['light', 400]]) {
    await withPage(file(name), {colorScheme, viewport: {width, height: 800}},
                   async (page, said) => {
      assert.strictEqual(await page.textContent('h1'), report.study);
      // Each requirement has a histogram with its name and a ranking; the
      // clearance and the angles are over time; eleven inputs take two.
      const pictures = await page.locator('figure svg').all();
      assert.strictEqual(pictures.length, 2 * worst.length + 4);
      for (const picture of pictures) {
        const box = await picture.boundingBox();
        assert.ok(box.width > 300 && box.height > 150, JSON.stringify(box));
        assert.ok(await picture.locator('path').count() > 5);
      }
      // The answers come first, with both probabilities.
      const verdicts = await page.locator('main > .verdict').allTextContents();
      assert.strictEqual(verdicts.length, report.requirements.length);
      for (const verdict of verdicts) {
        assert.match(verdict, /^(Met|Not met|Open): .*\d %.*\d % confidence/);
      }
      assert.match(verdicts[0], /smallest clearance at least 50 mm/);
      assert.match(verdicts[1], /rate at release of booster_\*/);
      const name = page.locator('tbody td').first();
      assert.strictEqual(await name.evaluate((cell) =>
          getComputedStyle(cell, '::before').content !== 'none'), width < 600);
      const text = await page.textContent('main');
      for (const {quantity} of report.requirements) {
        assert.ok(text.includes(quantity));
      }
      const [has, room] = await page.evaluate(
          () => [document.scrollingElement.scrollWidth, innerWidth]);
      assert.ok(has <= room, `${has} px`);
      assert.deepStrictEqual(said, []);
    });
  }
});

test('the worst runs link to their replays', async () => {
  const links = await withPage(file(name), {}, async (page) => {
    const rows = await page.locator('tr:has(a)').all();
    return Promise.all(rows.map(async (row) => ({
      run: Number(await row.locator('th').textContent()),
      address: await row.locator('a').evaluate((link) => link.href),
    })));
  });
  assert.deepStrictEqual(links.map(({run}) => run),
                         worst.flat().map(({run}) => run));
  for (const {run, address} of links) {
    assert.ok(fs.existsSync(new URL(address)), address);
  }
  // By a click, and alone.
  await withPage(file(name), {}, async (page, said) => {
    await page.locator('td a').first().click();
    await page.waitForURL(links[0].address);
    await page.evaluate(() => replay.ready);
    assert.ok((await page.textContent('#case pre')).includes(
        `# run ${links[0].run}: `));
    assert.ok(await page.isVisible('#fit'));
    // The nominal run beside it, faint.
    assert.ok((await page.textContent('#about')).startsWith(
        `run ${links[0].run} beside nominal`));
    assert.deepStrictEqual(said, [links[0].address]);
  });
  await withPage(fileURLToPath(links.at(-1).address), {}, async (page, said) => {
    await page.evaluate(() => replay.go(1));
    assert.deepStrictEqual(said, []);
  });
});

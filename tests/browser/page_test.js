// The page to calculate on, in a real browser: what it says while one types,
// links, mistakes, forged addresses, readers of screens, and its times.
'use strict';
const assert = require('assert');
const fs = require('fs');
const path = require('path');
const {test} = require('node:test');
const {withPage} = require('./chromium.js');
const ask = require('./engine.js');

const file = path.resolve(process.env.CONTACT_PAGE);
const data = path.resolve(__dirname, '../../data');
const joints = path.join(data, 'joints');

// Times of answers so far, ms.
const answers = (page, name = 'answer') => page.evaluate((of) =>
    performance.getEntriesByName(of).map(
        ({startTime, duration}) => ({startTime, duration})), name);

// After one more answer than there were, and curves if `all`.
async function afterAnswer(page, act, all = true) {
  const name = all ? 'curves' : 'answer';
  const {length} = await answers(page, name);
  await act();
  await page.waitForFunction(
      ([of, count]) => performance.getEntriesByName(of).length > count,
      [name, length]);
}
const opened = (page) => page.waitForFunction(
    () => performance.getEntriesByName('curves').length > 0);
const withCalculator = (options, use) => withPage(
    file, options, async (page, said) => {
      await opened(page);
      const result = await use(page, said);
      assert.deepStrictEqual(said, []);
      return result;
    });

// All numbers that it shows, as they are.
const numbersOf = (page) => page.evaluate(() => Object.fromEntries(
    [...document.querySelectorAll('#numbers tr')].map(({cells}) => [
      cells[0].textContent,
      /inf/.test(cells[1].textContent) ? cells[1].textContent :
          cells[1].textContent === '–' ? null : Number(cells[1].textContent)])));

async function engineNumbers(joint, state) {
  const {numbers} = await ask('answer', joint, state);
  return Object.fromEntries(numbers.map(({name, value}) => [name, value]));
}

test('it opens from the disk, answers while one types, asks for nothing',
     async (t) => {
  assert.ok(fs.statSync(file).size <= 1.5e6, `${fs.statSync(file).size} bytes`);
  await withCalculator({}, async (page) => {
    const [first] = await answers(page);
    t.diagnostic(`first answer ${
        (first.startTime + first.duration).toFixed(0)} ms after opening`);
    const before = await numbersOf(page);
    assert.ok(before.theta0_deg > 10 && before.theta0_deg < 90);
    await afterAnswer(page, () => page.fill('#load', '20'));
    const after = await numbersOf(page);
    assert.strictEqual(after.R_N, 20e3);
    assert.ok(after.theta0_deg > before.theta0_deg);
    assert.strictEqual(await page.textContent('#theta0_deg'),
                       after.theta0_deg.toPrecision(4) + '°');
    // Numbers shown are those of the file that is shown, to the last bit.
    const joint = await page.textContent('#ways pre >> nth=0');
    assert.deepStrictEqual(after, await engineNumbers(
        joint, 'reaction_kN = 20\nrate_deg_per_s = 10'));
    for (let load = 21; load <= 40; ++load) {
      await afterAnswer(page, () => page.fill('#load', String(load)), false);
    }
    const times = (await answers(page)).slice(-20)
        .map(({duration}) => duration).sort((a, b) => a - b);
    t.diagnostic(`an answer after a key ${times[10].toFixed(1)} ms (median), ${
        times[19].toFixed(1)} at most`);
  });
});

// A coated ball on a liner.
const lined = '#' + new URLSearchParams(
    {kind: 'ball', pair: 'steel_ptfe_liner.toml', wall: 'layer',
     coating: 'one'});

test('every joint of data is read, and every kind of field', async () => {
  await withCalculator({hash: lined}, async (page) => {
    const countOf = (folder) => fs.readdirSync(path.join(data, folder)).length;
    // Beside them: 'by their numbers'; rigid and held.
    assert.strictEqual(await page.locator('#pair option').count(),
                       countOf('materials') + 1);
    assert.strictEqual(await page.locator('#backing option').count(),
                       countOf('backings') + 3);
    await afterAnswer(page, () => page.click('#mode'));
    for (const name of fs.readdirSync(joints)) {
      await afterAnswer(page, () => page.selectOption('#example', name));
      assert.ok(await page.isHidden('#error'), name);
      const text = fs.readFileSync(path.join(joints, name), 'utf8');
      const isPin = /^kind = "pin"/m.test(text);
      assert.strictEqual(await page.isHidden('#beta'), isPin);
      assert.deepStrictEqual(await numbersOf(page), await engineNumbers(
          text, 'reaction_kN = 10\nrate_deg_per_s = 10\n' +
          (isPin ? '' : 'beta_deg = 90')), name);
    }
    await afterAnswer(page, () => page.click('#mode'));
    for (const [field, value] of [
      ['by', 'designation'], ['group', 'C3'], ['pair', 'steel_steel.toml'],
      ['wall', 'none'], ['friction', 'steel_steel_greased'], ['kind', 'pin'],
      ['by', 'fit'], ['pair', 'numbers'], ['wall', 'layer'],
      ['backing', 'numbers'], ['backing', 'held'], ['taken', 'maximum'],
      ['coating', 'one'], ['friction', 'viscous']]) {
      const isRefused = field === 'kind';  // a pin has no designation
      await afterAnswer(page, () => page.selectOption(`#${field}`, value),
                        !isRefused);
      assert.strictEqual(await page.isHidden('.said >> visible=true')
          .catch(() => true), !isRefused, `${field} ${value}`);
    }
    assert.ok((await page.textContent('#notes')).includes('H7/g6'));
  });
});

test('a link carries the inputs', async () => {
  const [hash, numbers] = await withCalculator({}, async (page) => {
    await afterAnswer(page, () => page.fill('#length', '33'));
    await afterAnswer(page, () => page.selectOption('#load_unit', 'lbf'));
    await page.click('#link');
    await page.waitForFunction(() => /Copied|Selected/.test(
        document.getElementById('copied').textContent));
    return [await page.evaluate(() => location.hash), await numbersOf(page)];
  });
  await withCalculator({hash}, async (page) => {
    assert.deepStrictEqual(await numbersOf(page), numbers);
    assert.strictEqual(await page.inputValue('#length'), '33');
  });
});

test('mistakes are said beside the field', async () => {
  await withCalculator({hash: lined}, async (page) => {
    for (const [field, value, rule] of [
      ['load', '-1', 'reaction_kN = -1 must be 0 to 1e+97 kN'],
      ['load', '', 'must be a number'], ['load', '1e999', 'must be'],
      ['load', 'NaN', 'must be'], ['beta', '181', 'must be'],
      ['diameter', '<script>alert(1)</script>', 'must be a number'],
      ['clearance', '99e3', 'clearance'], ['coefficient', '-0.1', 'must be'],
      ['thickness', '1e-9', 'thickness'], ['thickness', '0', 'must be'],
      ['coating_thickness', '-1', 'must be above 0'],
      ['coating_ratio', '0.7', 'must be 0 to 0.5'],
      ['viscous', '-1', 'must be']]) {
      if (field === 'viscous') {
        await afterAnswer(page, () => page.selectOption('#friction', 'viscous'));
      }
      const good = await page.inputValue(`#${field}`);
      await afterAnswer(page, () => page.fill(`#${field}`, value), false);
      const said = await page.textContent(`#${field}_said`);
      assert.ok(said.includes(rule), `${field} = ${value}: ${said} ${
          await page.textContent('#error')}`);
      assert.strictEqual(
          await page.getAttribute(`#${field}`, 'aria-invalid'), 'true');
      await afterAnswer(page, () => page.fill(`#${field}`, good));
      assert.ok(await page.isHidden(`#${field}_said`));
    }
    // Extremes have answers, or say that they have none.
    for (const value of ['0', '1e-300', '1e90']) {
      await afterAnswer(page, () => page.fill('#load', value), false);
      assert.ok(await page.isHidden('#load_said'), value);
    }
  });
});

test('forged addresses and files do nothing', async () => {
  const nasty = '"><img src=x onerror=alert(1)><script>alert(2)</script>';
  const forged = new URLSearchParams({
    kind: nasty, load: nasty, load_unit: nasty, pair: '../../etc/passwd',
    hole: '"\n[wall]\nbacking = "rigid', __proto__: 'x', constructor: 'y'});
  await withPage(file, {hash: `#${forged}`}, async (page, said) => {
    await page.waitForFunction(
        () => performance.getEntriesByName('answer').length > 0);
    assert.strictEqual(await page.inputValue('#kind'), 'pin');
    assert.ok((await page.textContent('#load_said')).includes('<script>'));
    assert.strictEqual(await page.locator('img').count(), 0);
    assert.deepStrictEqual(said, []);
  });
  const own = `name = ${JSON.stringify(nasty)}\n` +
      fs.readFileSync(path.join(joints, 'pin_joint.toml'), 'utf8')
          .replace(/^name.*\n/m, '');
  const hash = '#' + new URLSearchParams({file: own});
  await withCalculator({hash}, async (page) => {
    assert.strictEqual(await page.textContent('#name'), nasty);
    assert.strictEqual(await page.locator('img').count(), 0);
    for (const text of ['', '\0', '[['.repeat(2000), 'pair = "/etc/passwd"',
                        own + '\n[materials]\npair = "../../../etc/passwd"']) {
      await afterAnswer(page, () => page.fill('#file', text), false);
      assert.ok(await page.isVisible('#error'), text.slice(0, 40));
    }
    await afterAnswer(page, () => page.fill('#file', own));
    assert.ok(await page.isHidden('#error'));
  });
});

test('readers of screens find nothing amiss, and nothing is cut off',
     async () => {
  const axe = fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
  for (const colorScheme of ['light', 'dark']) {
    for (const width of [360, 900, 1600]) {
      // The policy of the page forbids scripts that tests bring.
      const options = {colorScheme, viewport: {width, height: 900},
                       bypassCSP: true};
      await withCalculator(options, async (page) => {
        const check = async () => {
          await page.evaluate(axe);
          const {violations} = await page.evaluate(() => axe.run());
          assert.deepStrictEqual(violations.map(({id, nodes}) =>
            [id, nodes.map(({html}) => html.slice(0, 200))]), []);
          const [has, room] = await page.evaluate(
              () => [document.scrollingElement.scrollWidth, innerWidth]);
          assert.ok(has <= room, `${has} px of ${room}`);
        };
        await check();
        await page.click('#all details >> nth=0');
        await afterAnswer(page, () => page.fill('#diameter', '-1'), false);
        await check();
        await afterAnswer(page, () => page.click('#mode'), false);
        await check();
      });
    }
  }
});

// Replays of hinge-separation in a real browser, beside the histories and
// summaries of the same runs: node replay_test.js BUILD_DIR
'use strict';
const assert = require('assert');
const {execFileSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {test} = require('node:test');
const validator = require('gltf-validator');
const {withPage} = require('./chromium.js');

const program =
    path.resolve(process.env.CONTACT_BUILD, 'bin/hinge-separation');
const cases = path.resolve(__dirname, '../../data/cases');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'replays-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true}));
const file = (name) => path.join(folder, name);

// What it prints.
const run = (name, ...options) =>
    execFileSync(program, [name, ...options],
                 {cwd: folder, stdio: ['ignore', 'pipe', 'ignore']});

// A history as columns of numbers (modes: words).
function history(name) {
  const [head, ...lines] =
      fs.readFileSync(file(name), 'utf8').trimEnd().split('\n');
  const rows = lines.map((line) => line.split(','));
  return Object.fromEntries(head.split(',').map((column, j) => [
    column, rows.map(({[j]: cell}) => cell === '' ? NaN :
        Number.isNaN(Number(cell)) ? cell : Number(cell))]));
}

// The same numbers in every run of the tests.
function random(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

// A case with other keys in its [run].
function withRun(name, keys) {
  const text = fs.readFileSync(path.join(cases, name + '.toml'), 'utf8')
      .replaceAll('"../', `"${path.dirname(cases)}/`)
      .replace(/output_step_s = .*\n/, '').replace('[run]\n', `[run]\n${keys}\n`);
  fs.writeFileSync(file(`fine_${name}.toml`), text);
  return file(`fine_${name}.toml`);
}

const toRow = (column, i) => (name) => column[name][i];

// From the carrier's centre of mass, as replays have it.
function poseOf(columns, i, body) {
  const at = toRow(columns, i);
  return {
    position: ['x_m', 'y_m', 'z_m'].map(
        (axis) => at(`${body}.${axis}`) - at(`${columns.carrier}.${axis}`)),
    rotation: ['qx', 'qy', 'qz', 'qw'].map((part) => at(`${body}.${part}`)),
  };
}

// The row of a time.
const rowAt = (columns, time) =>
    columns.time_s.findIndex((t) => Math.abs(t - time) < 1e-6);

const difference = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));
// Between two turns given as quaternions, deg.
const turn = (a, b) => 360 / Math.PI * Math.asin(Math.min(1, Math.min(
    difference(a, b), difference(a, b.map((x) => -x))) / 2));

test('the validator finds nothing in any case, alone or compared', async () => {
  for (const name of fs.readdirSync(cases)) {
    const compare = name === 'two_stage_turn.toml' ? ['--compare'] : [];
    run(path.join(cases, name), '--replay', 'a.glb', ...compare);
    const {issues} = await validator.validateBytes(
        new Uint8Array(fs.readFileSync(file('a.glb'))));
    assert.deepStrictEqual(issues.messages, [], name);
  }
});

// The page's poses are those of three.js, which reads the glTF in it. Against
// runs with eight times as many rows, at times between those of the replay.
for (const [name, step] of Object.entries({
  soyuz: 0.02, two_stage_turn: 0.01, slosh: 0.05, flywheels: 0.1,
  platform: 0.1})) {
  test(`poses of ${name} are those of a finer history`, async () => {
    const outputStep = (by) => `output_step_s = ${step / by}`;
    run(withRun(name, outputStep(8)), '--history', 'fine.csv');
    run(withRun(name, outputStep(1)), '--replay', 'a.html');
    const fine = history('fine.csv');
    const bodies = Object.keys(fine).filter((column) => column.endsWith('.qw'))
        .map((column) => column.slice(0, -3));
    fine.carrier = bodies[0];
    const next = random(21);
    const rows = Array.from(
        {length: 20}, () => Math.floor(next() * fine.time_s.length));
    await withPage(file('a.html'), {}, async (page, said) => {
      const {size, poses} = await page.evaluate((times) => ({
        size: JSON.parse(document.getElementById('data').textContent).size,
        poses: times.map((time) => {
          replay.go(time);
          replay.update();
          return JSON.parse(document.getElementById('data').textContent)
              .bodies.map((_, body) => replay.pose(body));
        }),
      }), rows.map((row) => fine.time_s[row]));
      rows.forEach((row, i) => bodies.forEach((body, j) => {
        const is = poses[i][j];
        const want = poseOf(fine, row, body);
        const where = `${body} at ${fine.time_s[row]} s`;
        assert.ok(difference(is.position, want.position) <= 1e-4 * size, where);
        assert.ok(turn(is.rotation, want.rotation) <= 0.05, where);
      }));
      assert.deepStrictEqual(said, []);
    });
  });
}

// As the page shows numbers: with 4 digits and a prefix.
const prefixes = {G: 1e9, M: 1e6, k: 1e3, m: 1e-3, µ: 1e-6};
function shown(text) {
  if (text === '–') return NaN;
  const [, number, prefix] =
      text.match(/^(-?[\d.e+-]+) ?([GMkmµ](?=N|Pa|J|m))?/);
  return Number(number) * (prefixes[prefix] || 1);
}

test('numbers of soyuz are those of the history and the summary', async () => {
  const summary = JSON.parse(run(
      path.join(cases, 'soyuz.toml'), '--history', 'a.csv', '--replay',
      'a.html'));
  assert.ok(fs.statSync(file('a.html')).size <= 2e6);
  const rows = history('a.csv');
  await withPage(file('a.html'), {}, async (page, said) => {
    for (const i of [0, 100, rows.time_s.length - 1]) {
      const cells = await page.evaluate((time) => {
        replay.go(time);
        replay.update();
        return [...document.querySelectorAll('[data-column]')].map(
            ({dataset, textContent}) => [dataset.column, textContent]);
      }, rows.time_s[i]);
      assert.ok(cells.length >= 4 * 8);
      for (const [column, text] of cells) {
        const want = rows[column][i];
        const is = shown(text);
        assert.ok(Object.is(is, want) || Math.abs(is - want) <=
            0.6e-3 * Math.abs(want), `${column}: ${text}, ${want}`);
      }
    }
    const text = await page.textContent('#summary');
    for (const {peak_reaction_N: peak} of summary.bodies.filter(
        (body) => body.peak_reaction_N)) {
      assert.ok(text.includes(String(Number(peak.toPrecision(6)))));
    }
    assert.strictEqual(await page.locator('#events button').count(),
                       summary.events.length);
    // An event is gone to, by its button and by its key.
    const last = summary.events.length - 1;
    await page.locator('#events button').nth(last).click();
    assert.strictEqual(await page.evaluate(() => replay.time),
                       summary.events[last].time_s);
    await page.keyboard.press('[');
    const before = await page.evaluate(() => replay.time);
    assert.ok(summary.events.some((event) => event.time_s === before));
    assert.ok(before < summary.events[last].time_s);
    assert.ok((await page.textContent('#about')).includes('fitted'));
    assert.ok((await page.textContent('#case pre')).includes(
        '# Masses, sizes and thrusts of a Soyuz-FG'));
    assert.deepStrictEqual(said, []);
  });
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html', '--no-case');
  assert.ok(!fs.readFileSync(file('a.html'), 'utf8').includes('Soyuz-FG'));
});

// Until somebody takes hold of it; slower near an event than far from it.
test('it plays by itself, slowly at events', async () => {
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html');
  await withPage(file('a.html'), {}, async (page, said) => {
    await page.reload();
    said.length = 0;
    await page.evaluate(() => replay.ready);
    await page.waitForFunction(() => replay.time > 0.05);
    const {time_s: event} = await page.evaluate(() => JSON.parse(
        document.getElementById('data').textContent).takes[0].summary.events[0]);
    const pace = (time) => page.evaluate((t) => replay.paceAt(t), time);
    assert.strictEqual(await pace(event), 1 / 6);
    assert.ok(Math.abs(await pace(event - 0.1) - 1 / 3) < 1e-9);
    assert.strictEqual(await pace(4), 1);
    await page.uncheck('#slow');
    assert.strictEqual(await pace(event), 1);
    assert.deepStrictEqual(said, []);
    await page.emulateMedia({reducedMotion: 'reduce'});
    await page.reload();
    await page.evaluate(() => replay.ready);
    await page.waitForTimeout(700);
    assert.strictEqual(await page.evaluate(() => replay.time), 0);
  });
});

// The thrusts of the file, and their decay: T exp(-t/0.4 s) between rows 0.02 s
// apart, straight lines within 0.03 %.
test('plumes are as long as thrusts are large', async () => {
  const {events} = JSON.parse(
      run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html'));
  const {time_s: cut} =
      events.find(({what}) => what.startsWith('lower nodes break'));
  await withPage(file('a.html'), {}, async (page, said) => {
    const lengths = (time) => page.evaluate((t) => {
      replay.go(t);
      replay.update();
      return [0, 1, 2, 3, 4].map(replay.plume);
    }, time);
    const [core, ...boosters] = await lengths(cut - 0.1);
    boosters.forEach((length, i) => assert.ok(Math.abs(
        length / core * 990.18 - (i === 2 ? 615 : 600)) < 0.01, `${i}`));
    const [still, ...less] = await lengths(cut + 0.41);
    assert.ok(Math.abs(still / core - 1) < 1e-6);  // floats
    less.forEach((length, i) => assert.ok(Math.abs(
        length / boosters[i] * Math.exp(0.41 / 0.4) - 1) < 1e-3, `${i}`));
    assert.deepStrictEqual(said, []);
  });
});

// The colours of the corner in a snapshot, by the number of their dots.
test('the corner has the contact of the chosen hinge', async () => {
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html');
  await withPage(file('a.html'), {}, async (page, said) => {
    const colours = () => page.evaluate(async () => {
      replay.update();
      const bitmap = await createImageBitmap(await replay.snapshot());
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [190, 150];
      const context = canvas.getContext('2d');
      context.drawImage(bitmap, bitmap.width - 198, 28, 190, 150, 0, 0, 190, 150);
      const {data: rgba} = context.getImageData(0, 0, 190, 150);
      const counts = {};
      for (let i = 0; i < rgba.length; i += 4) {
        const key = [0, 1, 2].map((k) => rgba[i + k] >> 5).join();
        counts[key] = (counts[key] ?? 0) + 1;
      }
      return Object.values(counts).filter((count) => count > 40).length;
    });
    await page.evaluate(() => replay.go(0.5));
    assert.ok(await page.isVisible('#contact'));
    assert.ok(await colours() > 8, `${await colours()} colours`);
    const text = () => page.textContent('#contact_text');
    assert.match(await text(), /θ₀ [\d.]+°  peak .*Pa\nfriction .*N m/);
    const first = await text();
    await page.selectOption('#follow', '3');
    await page.evaluate(() => replay.update());
    assert.strictEqual(await page.inputValue('#hinge'), '2');
    await page.evaluate(() => {
      replay.go(5);
      replay.update();
    });
    assert.strictEqual(await text(), 'no contact');
    assert.notStrictEqual(first, 'no contact');
    await page.uncheck('#show_contact');
    await page.evaluate(() => replay.update());
    assert.ok(await page.isHidden('#contact'));
    assert.deepStrictEqual(said, []);
  });
});

test('the keyboard alone suffices', async () => {
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html');
  await withPage(file('a.html'), {}, async (page, said) => {
    const reached = new Set();
    for (let i = 0; i < 40; ++i) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement.id ||
          document.activeElement.tagName));
    }
    for (const id of ['view', 'time', 'play', 'previous', 'next', 'speed',
                      'follow', 'turning', 'fit', 'show_forces', 'BUTTON',
                      'SUMMARY']) {
      assert.ok(reached.has(id), id);
    }
    const nameless = await page.evaluate(() => [...document.querySelectorAll(
        'button, input, select')].filter((element) =>
        element.offsetParent && !(element.ariaLabel || element.textContent.trim() ||
          element.closest('label'))).map((element) => element.outerHTML));
    assert.deepStrictEqual(nameless, []);
    const time = () => page.evaluate(() => replay.time);
    await page.focus('#time');
    await page.keyboard.press('PageUp');
    assert.ok(await time() > 0);
    await page.focus('#view');
    await page.keyboard.press('Home');
    assert.strictEqual(await time(), 0);
    await page.keyboard.press('.');
    assert.strictEqual(await time(), 0.02);
    await page.keyboard.press(' ');
    await page.waitForFunction(() => replay.time > 0.3);
    await page.keyboard.press(' ');
    const picture = () => page.locator('#view').screenshot();
    const before = await picture();
    await page.keyboard.press('ArrowLeft');
    await page.waitForTimeout(300);
    assert.notDeepStrictEqual(await picture(), before);
    await page.keyboard.press('f');
    assert.strictEqual(await page.inputValue('#follow'), '1');
    // The booster is in the middle then, and stays there.
    for (const time of [0.4, 3, 5]) {
      const offset = await page.evaluate((t) => {
        replay.go(t);
        replay.update();
        return replay.offset(1);
      }, time);
      assert.ok(Math.hypot(...offset) < 0.5, `${time} s: ${offset}`);
    }
    assert.deepStrictEqual(said, []);
  });
});

const cross = ([a, b, c], [x, y, z]) =>
    [b * z - c * y, c * x - a * z, a * y - b * x];
// v, turned by a quaternion.
function turned([x, y, z, w], v) {
  const half = cross([x, y, z], v).map((c, i) => c + w * v[i]);
  return cross([x, y, z], half).map((c, i) => v[i] + 2 * c);
}

// The platform spins, so that its arms move otherwise as seen from it.
test('who turns with a body sees it at rest and the others from it', async () => {
  run(path.join(cases, 'platform.toml'), '--history', 'a.csv', '--replay',
      'a.html');
  const rows = history('a.csv');
  rows.carrier = 'platform';
  const [begin, ...others] = [0.9, 2.5, 10.3].map(
      (time) => rowAt(rows, time));
  await withPage(file('a.html'), {}, async (page, said) => {
    // What was shown or hidden before changes the picture's size a frame later.
    const seen = (row, points) => page.evaluate(async ([time, of]) => {
      await new Promise((done) => requestAnimationFrame(
          () => requestAnimationFrame(done)));
      replay.go(time);
      replay.update();
      return of.map(([body, point]) => replay.offset(body, point)).flat();
    }, [rows.time_s[row], points]);
    const marks = (body) =>
        [[0, 0, 1], [0, 1, 0], [1, 0, 0]].map((point) => [body, point]);
    const inertial = await seen(begin, marks(0));
    await page.uncheck('#all');
    const later = await seen(others[0], marks(0));
    assert.ok(difference(later, inertial) > 50);
    await seen(begin, []);
    await page.focus('#view');
    await page.keyboard.press('t');
    assert.ok(await page.isChecked('#turning'));
    for (const row of [begin, ...others]) {
      assert.ok(difference(await seen(row, marks(0)), inertial) < 0.5);
      const {position} = poseOf(rows, row, 'arm_4');
      const [x, y, z, w] = poseOf(rows, row, 'platform').rotation;
      const place = turned([-x, -y, -z, w], position);
      const arm = await seen(row, [[4, [0, 0, 0]]]);
      assert.ok(difference(arm, await seen(begin, [[0, place]])) < 0.5);
    }
    await page.uncheck('#turning');
    assert.ok(difference(await seen(others[0], marks(0)), later) < 0.5);
    await page.check('#turning');
    // Another one goes into the middle as it is: from afar, without much of
    // perspective.
    for (let i = 0; i < 20; ++i) await page.keyboard.press('-');
    const before = await seen(others[1], marks(2));
    await page.selectOption('#follow', 'arm 2');
    const after = await seen(others[1], marks(2));
    const span = (p) => [p[2] - p[0], p[3] - p[1], p[4] - p[0], p[5] - p[1]];
    assert.ok(difference(span(after), span(before)) <
        0.05 * Math.hypot(...span(before)));
    for (const row of others) {
      assert.ok(difference(await seen(row, marks(2)), after) < 0.5);
    }
    assert.deepStrictEqual(said, []);
  });
});

test('arrows of locks are their reactions until they break', async () => {
  run(path.join(cases, 'platform.toml'), '--history', 'a.csv', '--replay',
      'a.html');
  const rows = history('a.csv');
  rows.carrier = 'platform';
  const most = Math.max(...[1, 2, 3, 4, 5, 6].map(
      (arm) => Math.max(...rows[`arm_${arm}.lock_reaction_N`])));
  await withPage(file('a.html'), {}, async (page, said) => {
    const arrow = (time, arm, kind) => page.evaluate(([t, body, name]) => {
      replay.go(t);
      replay.update();
      return replay.arrow(body, name);
    }, [time, arm, kind]);
    const size = await page.evaluate(() => JSON.parse(
        document.getElementById('data').textContent).size);
    for (const [time, arm] of [[0.3, 1], [0.9, 5], [3, 4]]) {
      const row = rowAt(rows, time);
      const [from, tip] = await arrow(time, arm, 'lock');
      const {position, rotation} = poseOf(rows, row, `arm_${arm}`);
      // Of the case, from the middle of the arm.
      const point = turned(rotation, [0.1 - 0.15, 0, 1 - 0.55]);
      assert.ok(difference(from, position.map((x, i) => x + point[i])) <
          1e-3 * size);
      // 0.42 of the size for the largest one.
      const force = ['x', 'y', 'z'].map(
          (axis) => rows[`arm_${arm}.lock_reaction_${axis}_N`][row]);
      assert.ok(difference(tip, from.map(
          (x, i) => x + 0.42 * size * force[i] / most)) < 1e-6 * size);
    }
    assert.strictEqual(await arrow(1.5, 1, 'lock'), undefined);
    assert.ok(await arrow(1.5, 1, 'reaction'));
    assert.ok((await page.textContent('#legend')).includes(
        'reaction of locks, up to 7.698 N'));
    await page.uncheck('#show_forces');
    assert.strictEqual(await arrow(0.3, 1, 'lock'), undefined);
    assert.deepStrictEqual(said, []);
  });
  // Only where there are locks has the page their components.
  run(path.join(cases, 'two_stage_turn.toml'), '--replay', 'a.html');
  assert.ok(!fs.readFileSync(file('a.html'), 'utf8').includes(
      '.lock_reaction_x_N'));
});

test('forces of the case are drawn where they act', async () => {
  run(path.join(cases, 'soyuz.toml'), '--history', 'a.csv', '--replay',
      'a.html');
  const rows = history('a.csv');
  rows.carrier = 'core';
  await withPage(file('a.html'), {}, async (page, said) => {
    const {size, forces, bodies} = await page.evaluate(() => JSON.parse(
        document.getElementById('data').textContent));
    const engine = forces.findIndex(({name}) => name === 'core engine');
    const most = await page.evaluate((i) => replay.mostForce(i), engine);
    for (const time of [0.2, 1, 3]) {
      const arrow = (kind) => page.evaluate(([t, i, name]) => {
        replay.go(t);
        replay.update();
        return replay.force(i, name);
      }, [time, engine, kind]);
      const {position, rotation} =
          poseOf(rows, rowAt(rows, time), bodies[forces[engine].body].column);
      const {point} = forces[engine];
      const [from, tip] = await arrow('arrow');
      assert.ok(difference(from, turned(rotation, point).map(
          (x, i) => x + position[i])) < 1e-3 * size);
      // The largest of those from outside, along the core.
      const way = turned(rotation, [1, 0, 0]);
      assert.ok(difference(tip, from.map((x, i) => x + most * way[i])) <
          2e-3 * size);
      assert.strictEqual(await arrow('opposite'), undefined);
    }
    assert.ok(Math.abs(most - 0.42 * size) < 1e-3 * size);
    assert.match(await page.textContent('#legend'),
                 /forces from outside, up to 990.2 kN/);
    assert.match(await page.textContent('#force_values'), /990.2 kN/);
    await page.uncheck('#show_forces');
    assert.strictEqual(await page.evaluate((i) => {
      replay.update();
      return replay.force(i, 'arrow');
    }, engine), undefined);
    assert.deepStrictEqual(said, []);
  });
});

test('forces between two bodies are on both until they end', async () => {
  fs.writeFileSync(file('spring.toml'), `
name = "spring"
run = { end_time_s = 1, output_step_s = 0.01 }
carrier = { name = "a", mass_kg = 1, principal_inertia_kg_m2 = [1, 1, 1] }
[[body]]
name = "b"
mass_kg = 1
principal_inertia_kg_m2 = [1, 1, 1]
start = { position_m = [0, 0, 1] }
[[force]]
name = "push"
body = "b"
kind = "spring"
point_m = [0, 0, -0.2]
carrier_point_m = [0, 0, 0.2]
stiffness_N_per_m = 1
free_length_m = 2
ends_at_s = 0.5
`);
  run(file('spring.toml'), '--replay', 'a.html');
  await withPage(file('a.html'), {}, async (page, said) => {
    const arrows = (time) => page.evaluate((t) => {
      replay.go(t);
      replay.update();
      return ['arrow', 'opposite'].map((kind) => replay.force(0, kind));
    }, time);
    const [[from, tip], [other, back]] = await arrows(0);
    assert.ok(difference(from, [0, 0, 0.8]) < 1e-6);
    assert.ok(difference(other, [0, 0, 0.2]) < 1e-6);
    assert.ok(tip[2] > from[2]);
    assert.ok(Math.abs(tip[2] - from[2] + back[2] - other[2]) < 1e-6);
    assert.deepStrictEqual(await arrows(0.6), [undefined, undefined]);
    assert.ok((await page.textContent('#legend')).includes(
        'forces between bodies, up to 1.4 N'));
    assert.deepStrictEqual(said, []);
  });
});

test('bodies that are let go stay in view until one goes nearer', async () => {
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html');
  await withPage(file('a.html'), {}, async (page, said) => {
    const outside = (time) => page.evaluate((t) => {
      replay.go(t);
      replay.update();
      const {clientWidth, clientHeight} = document.getElementById('scene');
      return [0, 1, 2, 3, 4].filter((body) => {
        const [x, y] = replay.offset(body);
        return Math.abs(x) > clientWidth / 2 || Math.abs(y) > clientHeight / 2;
      });
    }, time);
    const lengthOf = () => page.evaluate(() => {
      const scale = document.getElementById('scale');
      return [scale.textContent, parseFloat(scale.style.width)];
    });
    assert.deepStrictEqual(await outside(0), []);
    const first = await lengthOf();
    assert.match(first[0], /^\d+ m$/);
    assert.ok(first[1] >= 40 && first[1] <= 100);
    assert.deepStrictEqual(await outside(6), []);
    assert.notDeepStrictEqual(await lengthOf(), first);
    // And back.
    await outside(0);
    assert.deepStrictEqual(await lengthOf(), first);
    await page.focus('#view');
    await page.keyboard.press('+');
    await outside(0.1);
    assert.ok(!await page.isChecked('#all'));
    assert.notDeepStrictEqual(await outside(6), []);
    await page.keyboard.press('a');
    assert.deepStrictEqual(await outside(6), []);
    assert.deepStrictEqual(said, []);
  });
});

test('the scale is under no name, and a pause is drawn', async () => {
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html');
  for (const width of [1600, 1240, 900, 360]) {
    await withPage(file('a.html'), {viewport: {width, height: 800}},
                   async (page, said) => {
      for (const time of [0, 0.6, 1.3, 2]) {
        const over = await page.evaluate((t) => {
          replay.go(t);
          replay.update();
          const scale = document.getElementById('scale').getBoundingClientRect();
          return [...document.querySelectorAll('#labels div:not([hidden])')]
              .filter((label) => {
                const box = label.getBoundingClientRect();
                return box.right > scale.left && box.left < scale.right &&
                    box.bottom > scale.top && box.top < scale.bottom;
              }).map((label) => label.textContent);
        }, time);
        assert.deepStrictEqual(over, [], `${width} px, ${time} s`);
      }
      // No text: a font may lack it.
      const bars = await page.evaluate(() => {
        replay.play(true);
        const play = document.getElementById('play');
        const {content, height} = getComputedStyle(play, '::before');
        return [play.textContent, content, parseFloat(height) > 8];
      });
      assert.deepStrictEqual(bars, ['', '""', true]);
      assert.deepStrictEqual(said, []);
    });
  }
});

test('the nearest two and all events of an instant are named', async () => {
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html');
  await withPage(file('a.html'), {}, async (page, said) => {
    await page.evaluate(() => {
      replay.go(0.5);
      replay.update();
    });
    const now = await page.textContent('#now');
    assert.ok(now.includes('booster 1, booster 2, booster 3, booster 4: ' +
        'lower nodes break · '), now);
    assert.ok(await page.locator('#events .current').count() >= 4);
    assert.match(await page.textContent('#labels .distance'),
                 /^(core|booster \d), booster \d: [\d.]+ m?m$/);
    assert.deepStrictEqual(
        await page.locator('#compass text').allTextContents(),
        ['x', 'y', 'z', 'g']);
    // A colour and a name for each pair.
    const key = page.locator('.curve', {hasText: 'Clearance'}).locator('li');
    const data = await page.evaluate(() => JSON.parse(
        document.getElementById('data').textContent));
    assert.strictEqual(await key.count(), data.pairs.length);
    const colours = await key.locator('.swatch').evaluateAll(
        (all) => all.map((swatch) => swatch.style.background));
    assert.strictEqual(new Set(colours).size, data.pairs.length);
    assert.deepStrictEqual(said, []);
  });
});

test('pictures and films are saved', async () => {
  run(path.join(cases, 'two_stage_turn.toml'), '--replay', 'a.html');
  await withPage(file('a.html'), {acceptDownloads: true}, async (page) => {
    const saved = async (act) => {
      const [download] =
          await Promise.all([page.waitForEvent('download'), act()]);
      return {name: download.suggestedFilename(),
              bytes: fs.readFileSync(await download.path())};
    };
    await page.evaluate(() => {
      replay.go(1.25);
      replay.update();
    });
    await page.focus('#view');
    const picture = await saved(() => page.keyboard.press('p'));
    assert.match(picture.name, /^[\w-]+_1_250s\.png$/);
    assert.strictEqual(picture.bytes.toString('latin1', 1, 4), 'PNG');
    // As wide as the canvas; more than one colour.
    const width = await page.evaluate(
        () => document.getElementById('view').width);
    assert.strictEqual(picture.bytes.readUInt32BE(16), width);
    assert.ok(picture.bytes.length > 10000);
    await page.selectOption('#speed', '5');
    const film = await saved(() => page.click('#save_film'));
    assert.match(film.name, /_frames\.zip$/);
    // 2.6 s in steps of 0.2 s.
    const names = film.bytes.toString('latin1').match(/frame_\d{4}\.png/g);
    assert.deepStrictEqual([...new Set(names)], Array.from(
        {length: 14}, (_, i) => `frame_${String(i).padStart(4, '0')}.png`));
    assert.strictEqual(await page.textContent('#save_film'), 'Film');
  });
});

test('the bodies stay in the canvas, for whoever takes a picture of the page',
     async () => {
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html');
  await withPage(file('a.html'), {}, async (page) => {
    // The first picture takes a second on a busy machine; then a frame later.
    await page.evaluate(() => {
      replay.go(1);
      replay.update();
    });
    await page.waitForTimeout(500);
    const colours = await page.evaluate(() => {
      const view = document.getElementById('view');
      const canvas = document.createElement('canvas');
      canvas.width = view.width;
      canvas.height = view.height;
      const context = canvas.getContext('2d');
      context.drawImage(view, 0, 0);
      const {data} = context.getImageData(0, 0, view.width, view.height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
    // Shaded cylinders; one where nothing is left.
    assert.ok(colours > 50, `${colours} colours`);
  });
});

test('on a phone, in the dark and in the light nothing is wider than the screen',
     async () => {
  run(path.join(cases, 'platform.toml'), '--replay', 'a.html');
  for (const colorScheme of ['dark', 'light']) {
    await withPage(file('a.html'),
                   {colorScheme, viewport: {width: 360, height: 740}},
                   async (page, said) => {
      const [has, room, back] = await page.evaluate(() => [
        document.scrollingElement.scrollWidth, innerWidth,
        getComputedStyle(document.body).backgroundColor]);
      assert.ok(has <= room);
      const light = Number(back.match(/\d+/)[0]);
      assert.ok(colorScheme === 'dark' ? light < 60 : light > 200);
      assert.deepStrictEqual(said, []);
    });
  }
});

test('without WebGL curves and tables are there', async () => {
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html');
  const noWebgl = (page) => page.addInitScript(() => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function(kind, ...rest) {
      return kind.includes('webgl') ? null : get.call(this, kind, ...rest);
    };
  });
  await withPage(file('a.html'), {}, async (page) => {
    assert.ok(await page.isVisible('#no_webgl'));
    assert.ok(!await page.isVisible('#fit'));
    assert.strictEqual(await page.locator('.graph canvas').count(), 12);
    await page.keyboard.press(']');
    await page.waitForFunction(() => replay.time === 0.5 &&
        document.getElementById('clock').textContent === '0.500 s');
    assert.ok((await page.textContent('#values')).includes('kN'));
  }, noWebgl);
});

test('who wants no motion gets two pictures a second', async () => {
  run(path.join(cases, 'soyuz.toml'), '--replay', 'a.html');
  // The shortest step of the time, which goes on as clocks do away from events.
  const step = (reducedMotion) => withPage(
      file('a.html'), {reducedMotion}, (page) => page.evaluate(async () => {
        document.getElementById('slow').checked = false;
        const times = [replay.time];
        replay.play(true);
        while (times.length < 6) {
          if (replay.time > times.at(-1)) times.push(replay.time);
          await new Promise(requestAnimationFrame);
        }
        return Math.min(...times.slice(1).map((time, i) => time - times[i]));
      }));
  assert.ok(await step('reduce') > 0.499);
  assert.ok(await step('no-preference') < 0.5);
});

test('text of files stays text', async () => {
  const nasty = '</script><script>alert(1)</script><img src=x onerror=alert(2)>';
  const quotes = '\'quoted" &amp; {{data}} \\u003c \u2028\u0001\u001b ]]>';
  const name = JSON.stringify(`${nasty}${quotes}`);
  const body = JSON.stringify(`<b onclick='alert(3)'>\\${nasty.slice(0, 8)}`
      .replace('/', '|'));
  fs.writeFileSync(file('nasty.toml'), `
name = ${name} # <!-- <script> --> ${nasty}
run = { end_time_s = 1 }
carrier = { name = "a", mass_kg = 1, principal_inertia_kg_m2 = [1, 1, 1] }
[[body]]
name = ${body}
mass_kg = 1
principal_inertia_kg_m2 = [1, 1, 1]
[body.hinge]
kind = "ball"
name = ${name}
body_point_m = [0, 0, 1]
[[event]]
name = ${name}
time_s = 0.5
breaks = "hinge"
`);
  run(file('nasty.toml'), '--replay', 'a.html', '--replay', 'a.glb');
  const {issues} = await validator.validateBytes(
      new Uint8Array(fs.readFileSync(file('a.glb'))));
  assert.strictEqual(issues.numErrors + issues.numWarnings, 0);
  await withPage(file('a.html'), {}, async (page, said) => {
    // Titles of windows have no control characters.
    assert.strictEqual(await page.title(),
                       JSON.parse(name).replace(/[\u0001\u001b]/g, ''));
    assert.strictEqual(await page.textContent('h1'), JSON.parse(name));
    const labels = await page.locator('#labels .body').allTextContents();
    assert.deepStrictEqual(labels, ['a', JSON.parse(body)]);
    assert.strictEqual(await page.locator('script').count(), 2);
    assert.strictEqual(await page.locator('img, b[onclick]').count(), 0);
    assert.ok((await page.textContent('#case pre')).includes(nasty));
    // What scripts and requests there might yet be, the policy forbids.
    const blocked = await page.evaluate(() => new Promise((resolve) => {
      document.addEventListener('securitypolicyviolation',
                                (event) => resolve(event.effectiveDirective));
      const script = document.createElement('script');
      script.textContent = 'alert(4)';
      document.body.append(script);
    }));
    assert.strictEqual(blocked, 'script-src-elem');
    await assert.rejects(page.evaluate(() => fetch('https://example.org')));
    assert.ok(!said.some((text) => /^\d$/.test(text)));
  });
});

test('fifty bodies and 10,000 rows are one page', async () => {
  fs.writeFileSync(file('many.toml'), `
name = "fifty pendulums"
gravity_m_per_s2 = [0, 0, -9.81]
run = { end_time_s = 10, output_step_s = 1e-3 }
carrier = { name = "ring", fixed = true }
[[body]]
name = "pendulum"
mass_kg = 1
principal_inertia_kg_m2 = [0.01, 0.01, 0.01]
pattern = { count = 50, axis = [0, 0, 1] }
start = { rate_deg_per_s = 100 }
[body.hinge]
kind = "axis"
body_point_m = [0, 0, 1]
carrier_point_m = [5, 0, 0]
axis = [0, 1, 0]
`);
  run(file('many.toml'), '--replay', 'a.html');
  assert.ok(fs.statSync(file('a.html')).size <= 50e6);
  await withPage(file('a.html'), {}, async (page) => {
    const times = await page.evaluate(() => Array.from({length: 60}, (_, i) => {
      replay.go(i / 6 + 0.123);
      replay.update();
      return replay.ownTime;
    }));
    times.sort((a, b) => a - b);
    console.log(`own script: ${times[30].toFixed(2)} ms a frame (median), ` +
        `${times[59].toFixed(2)} at most`);
  });
});

// The scripts of a replay's page that need no browser: what they make of its
// data, and the archive of a film.
'use strict';
const assert = require('assert');
const {execFileSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {test} = require('node:test');
const vm = require('vm');

const folder =
    path.resolve(__dirname, '../../apps/programs/separation/replay');
const base64 = (numbers) => Buffer.from(numbers.buffer).toString('base64');

// The scripts with these data, and what they have of these names.
function scripts(data, names) {
  const context = vm.createContext({
    atob, Dygraph: {PLUGINS: [], Plugins: {}}, matchMedia: () => ({}),
    document: {getElementById: () => ({textContent: JSON.stringify(data)})},
  });
  const text = ['data.js', 'curves.js', 'zip.js'].map(
      (name) => fs.readFileSync(path.join(folder, name), 'utf8')).join('\n');
  return vm.runInContext(`${text}\n({${names.join(', ')}})`, context);
}

const page = (more = {}) => ({
  bodies: [{name: 'a', column: 'a'}, {name: 'b', column: 'b'}],
  pairs: [[0, 1]],
  forces: [{}, {}],
  takes: [{
    name: '', friction: 'full',
    time: base64(Float64Array.of(0, 1, 2, 2, 3)),
    columns: {'b.mode': base64(Float32Array.of(0, 0, 0, 3, 3))},
    summary: {events: []}, ...more,
  }],
});

test('events of one instant are together', () => {
  const events = [[1, 'b', 'locks break: lock breaks'], [2, 'b', 'axis breaks'],
                  [2, 'c', 'axis breaks'], [2 + 5e-10, 'd', 'slides'],
                  [2.001, 'd', 'rests']]
      .map(([time, body, what]) => ({time_s: time, body, what}));
  const {instants, instantText} =
      scripts(page({summary: {events}}), ['instants', 'instantText']);
  assert.deepStrictEqual([...instants].map(({events: all}) => all.length),
                         [1, 3, 1]);
  assert.strictEqual(instantText(instants[0]), '1.000 s  b: locks break');
  assert.strictEqual(instantText(instants[1]),
                     '2.000 s  b, c: axis breaks · d: slides');
});

test('forces between rows', () => {
  const row = (a, b) => [a, 0, 0, 0, 0, 2 * a, b, 0, 0, 0, 0, 0];
  const forces = base64(Float32Array.from(
      [row(1, NaN), row(3, NaN), row(5, 7), row(NaN, 7), row(NaN, 8)].flat()));
  const {take} = scripts(page({forces}), ['take']);
  const at = (time, number) => {
    take.go(time);
    const acts = take.force(number);
    return acts && [acts.force[0], acts.moment[2]];
  };
  assert.deepStrictEqual(at(0, 0), [1, 2]);
  assert.deepStrictEqual(at(0.25, 0), [1.5, 3]);
  assert.deepStrictEqual(at(1.5, 0), [4, 8]);
  assert.strictEqual(at(2, 0), undefined);
  assert.strictEqual(at(1.5, 1), undefined);
  assert.deepStrictEqual(at(2.5, 1), [7.5, 0]);
  assert.deepStrictEqual(at(3, 1), [8, 0]);
});

test('curves on each other are dashed so that all are seen', () => {
  const {curvesBelow, strokePattern} =
      scripts(page(), ['curvesBelow', 'strokePattern']);
  const time = Array.from({length: 1000}, (_, i) => i);
  const run = {time};
  const curve = (at, more) => ({run, at, ...more});
  const sine = (i) => Math.sin(i / 50);
  const curves = [
    curve(sine), curve((i) => -sine(i)), curve((i) => sine(i) + 1e-3),
    curve((i) => i < 500 ? sine(i) : null), curve(sine, {dashed: true}),
    {run: {time}, at: sine, faint: true}, curve((i) => sine(i) + 0.1),
    curve((i) => sine(i) + (i > 600 ? 0.1 : 0))];
  assert.deepStrictEqual([...curvesBelow(curves)], [0, 0, 1, 2, 0, 0, 0, 4]);
  const power = (of) => curve((i) => 10 ** (i / 250 - of));
  const all = [power(2), power(2.1), power(2.001)];
  assert.deepStrictEqual([...curvesBelow(all, true)], [0, 0, 1]);
  // Of a line each pattern, the last on top, leaves some of those below.
  const top = Array(96).fill(0);
  [1, 2, 3].forEach((below) => {
    const [dash, gap] = strokePattern({}, below);
    top.forEach((_, i) => {
      if (i % (dash + gap) < dash) top[i] = below;
    });
  });
  for (const below of [0, 1, 2, 3]) {
    assert.ok(top.filter((x) => x === below).length >= 6, String(below));
  }
  assert.strictEqual(strokePattern({}, 0), null);
});

test('a film is an archive that others read', (t) => {
  const {zipped} = scripts(page(), ['zipped']);
  const files = [['frame_0000.png', new Uint8Array([1, 2, 3, 250])],
                 ['frame_0001.png', new Uint8Array(0)],
                 ['frame_0002.png', new Uint8Array(70000).fill(77)]];
  const bytes = Buffer.concat([...zipped(files)].map((part) => Buffer.from(part)));
  const place = fs.mkdtempSync(path.join(os.tmpdir(), 'film-'));
  t.after(() => fs.rmSync(place, {recursive: true}));
  const name = path.join(place, 'film.zip');
  fs.writeFileSync(name, bytes);
  execFileSync('python3', ['-c', 'import sys, zipfile\n' +
      'film = zipfile.ZipFile(sys.argv[1])\nassert film.testzip() is None\n' +
      'film.extractall(sys.argv[2])', name, place]);
  assert.deepStrictEqual(fs.readdirSync(place).sort(),
                         ['film.zip', ...files.map(([file]) => file)]);
  for (const [file, content] of files) {
    assert.ok(fs.readFileSync(path.join(place, file)).equals(
        Buffer.from(content)));
  }
});

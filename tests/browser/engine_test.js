// The page's engine, in WebAssembly, beside hinge-joint and hinge-pressure for
// every joint that is shipped; in node.
'use strict';
const assert = require('assert');
const {spawnSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {test} = require('node:test');
const ask = require('./engine.js');

const bin = path.resolve(process.env.CONTACT_BUILD, 'bin');
const joints = path.resolve(__dirname, '../../data/joints');

// Its functions of the C library round otherwise than those of the programs; the
// equations of a thin liner multiply such roundings by up to 2e3.
const tolerance = 1e-12;

// Relative to `size` where numbers are parts of something larger.
function errorOf(value, expected, size) {
  if (value === expected || (value === null && expected === undefined)) return 0;
  if (typeof value !== 'number' || typeof expected !== 'number') return Infinity;
  return Math.abs(value - expected) / Math.max(Math.abs(expected), size);
}

const rows = (program, ...options) => JSON.parse(spawnSync(
    path.join(bin, program), [...options, '--format', 'json'],
    {encoding: 'utf8'}).stdout);

// How the solver came to the numbers, which they stop at by rounding.
const ofTheWay = ['evaluations', 'residual'];

// Vectors' parts are as exact as the vector is long, and coefficients of sliding
// and spinning as that of both.
const sizeOf = (name, row) => {
  if (/^f_(sliding|spinning)$/.test(name)) return row.f_M ?? 0;
  const [, stem, unit] = /^(.*)_[xyz](_.*)?$/.exec(name) ?? [];
  return stem === undefined ? 0 : Math.abs(row[stem + (unit ?? '')] ?? 1);
};

for (const name of fs.readdirSync(joints)) {
  test(`${name}: numbers are those of the programs`, async (t) => {
    const text = fs.readFileSync(path.join(joints, name), 'utf8');
    const file = path.join(joints, name);
    const isPin = /^kind = "pin"/m.test(text);
    let worst = {error: 0};
    const compare = (value, expected, size, what) => {
      const error = errorOf(value, expected, size);
      if (error > worst.error) worst = {error, what, value, expected};
    };
    for (const load of ['0', '1', '10', '300']) {
      for (const beta of isPin ? ['90'] : ['0', '35', '90', '180']) {
        const [row] = rows('hinge-joint', '--joint', file, '--reaction',
                           `${load}kN`, '--rate', '7deg_per_s', '--pv',
                           ...(isPin ? [] : ['--beta', beta]),
                           // The page leaves rims and reliefs out.
                           ...['seat', 'relief'].filter((part) =>
                               text.includes(`\n[${part}]`)).map((part) =>
                               `--without-${part}`));
        const answer = await ask('answer', text, `reaction_kN = ${load}\n` +
            `rate_deg_per_s = 7\n${isPin ? '' : `beta_deg = ${beta}`}`);
        assert.strictEqual(answer.error, undefined);
        const number = {};
        for (const {name: column, value} of answer.numbers) {
          number[column] = value;
          if (ofTheWay.includes(column)) continue;
          compare(value, row[column], sizeOf(column, row),
                  `${column} at ${load} kN, ${beta} deg`);
        }
        for (const word of ['law', 'pressure', 'state', 'status']) {
          assert.strictEqual(answer.words[word], row[word]);
        }
        if (!(number.R_n_N > 0)) continue;
        const profile = rows('hinge-pressure', '--joint', file, '--load',
                             String(number.R_n_N), '--points', '101');
        const column = Object.keys(profile[0]).find((key) => /^p_/.test(key));
        profile.slice(0, -1).forEach((at, i) => {
          compare(answer.pressure.p_Pa[i], at[column], number.p_peak_Pa,
                  `pressure at ${at.theta_deg} deg of ${number.theta0_deg}`);
        });
      }
    }
    t.diagnostic(`largest difference ${worst.error.toExponential(1)}, ${
        worst.what}`);
    assert.ok(worst.error <= tolerance, JSON.stringify(worst));
  });
}

test('it computes in vectors', () => {
  const code = fs.readFileSync(
      path.resolve(process.env.CONTACT_ENGINE).replace(/js$/, 'wasm'));
  // f64x2.mul
  const count = code.toString('latin1').split('\xfd\xf2\x01').length - 1;
  assert.ok(count > 1000, `${count} multiplications`);
});

// The interpreter that the package is built for.
const pythonOf = (build) => /^_Python_EXECUTABLE:INTERNAL=(.*)$/m.exec(
    fs.readFileSync(path.join(build, 'CMakeCache.txt'), 'utf8'))[1];

test('the C++ and the Python that it writes give its numbers', async (t) => {
  const text = fs.readFileSync(path.join(joints, 'hip_cup.toml'), 'utf8');
  const {numbers, same} = await ask('answer', text,
      'reaction_kN = 2\nrate_deg_per_s = 40\nbeta_deg = 70');
  const number = Object.fromEntries(
      numbers.map(({name, value}) => [name, value]));
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'page-'));
  t.after(() => fs.rmSync(folder, {recursive: true}));
  for (const [name, content] of [['joint.toml', same.file], ['a.cpp', same.cpp],
                                 ['a.py', same.python]]) {
    fs.writeFileSync(path.join(folder, name), content);
  }
  const run = (command, args, env = {}) => {
    const {stdout, stderr, status} = spawnSync(
        command, args, {cwd: folder, encoding: 'utf8',
                        env: {...process.env, ...env}});
    assert.strictEqual(status, 0, stderr);
    return stdout;
  };
  const build = path.resolve(process.env.CONTACT_BUILD);
  const root = path.resolve(__dirname, '../..');
  run('c++', ['-std=c++20', `-I${root}`, `-I${build}/include`,
              '-I/usr/include/eigen3', 'a.cpp',
              `${build}/libcontact/libcontact_files.a`,
              `${build}/libcontact/libcontact.a`, '-o', 'a']);
  const said = [
    run(path.join(folder, 'a'), []),
    run(pythonOf(build), ['a.py'], {PYTHONPATH: path.join(build, 'python')}),
  ];
  for (const each of said) {
    const [halfAngle, peak] = each.match(/-?\d[\d.e+-]*/g).map(Number);
    assert.ok(errorOf(halfAngle * 180 / Math.PI, number.theta0_deg, 0) <= tolerance);
    assert.ok(errorOf(peak, number.p_peak_Pa, 0) <= tolerance);
  }
});

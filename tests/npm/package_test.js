// The npm package in node: its numbers beside the library's, what it refuses,
// its memory, and an installed copy.
//   CONTACT_BUILD  a build with the Python package
//   CONTACT_NPM    the package's folder
'use strict';
const assert = require('node:assert');
const {execFileSync, spawnSync} = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const {before, test} = require('node:test');
const {pathToFileURL} = require('node:url');

const build = path.resolve(process.env.CONTACT_BUILD);
const folder = path.resolve(process.env.CONTACT_NPM);
const joints = path.resolve(__dirname, '../../data/joints');

let contact;
before(async () => {
  const {load} = await import(pathToFileURL(path.join(folder, 'index.js')));
  contact = await load();
});

// Numbers in [0, 1) that are the same everywhere: xorshift of 32 bits.
let seed = 1;
function random() {
  seed ^= seed << 13;
  seed ^= seed >>> 17;
  seed ^= seed << 5;
  return (seed >>> 0) / 2 ** 32;
}
const vector = (length) => {
  const v = [0, 0, 0].map(() => random() - 0.5);
  return v.map((x) => x * length / Math.hypot(...v));
};
const logUniform = (low, high) => low * (high / low) ** random();

// How the solver came to the numbers is no number of the joint.
const ofTheWay = ['status', 'evaluations', 'residual', 'state', 'contact_state'];

// Random states, of which seats have none here: the contact of a random load
// would leave them. Slices of a pin that ends take 50 times as long.
function statesOf(file, joint) {
  const n = /relieved/.test(file) ? 20 : 200;
  const axis = joint.kind === 'pin' ? [0, 0, 1] : null;
  const all = (make) => Array.from({length: n}, make);
  const turn = (size) => axis ? [0, 0, (random() - 0.5) * size] : vector(size);
  return {
    without_seat: joint.has_seat, axis, inertia: [2, 0, 0, 0, 2, 0, 0, 0, 2],
    keys: contact.quantities.solution.map(({key}) => key)
        .filter((key) => !ofTheWay.includes(key)),
    reactions: all(() => vector(logUniform(1, 1e5))),
    rates: all(() => turn(logUniform(1e-3, 10))),
    moments: all(() => turn(logUniform(1e-3, 100))),
    free: all(() => turn(1)),
  };
}

// Largest difference, relative to a vector's length. Numbers that are as exact
// as a sum that has them in it are compared to that.
const sizeOf = {reaction_angle: 1, friction_angle: 1, slip_axis_angle: 1,
                normal: 1,
                step_rate: 1,  // `free`, whose share of 1e-12 a step may leave
                sliding_coefficient: 'moment_coefficient',
                spinning_coefficient: 'moment_coefficient'};
function difference(key, computed, expected, expectedOf, i) {
  if (expected === null || Number.isNaN(expected)) {  // of JSON, NaN
    return Number.isNaN(computed) ? 0 : Infinity;
  }
  const [a, b] = [[computed].flat(), [expected].flat()];
  const of = sizeOf[key];
  const size = Math.max(Math.hypot(...b),
                        typeof of === 'string' ? Math.abs(expectedOf[of][i]) : of ?? 0);
  return a.reduce((worst, x, k) => x === b[k] ? worst :
      Math.max(worst, Math.abs(x - b[k]) / size), 0);
}

// Functions of the C library round otherwise here; the equations of a thin liner
// multiply such roundings by up to 2e3. Measured: 8e-14, and 6e-13 there.
const tolerance = 1e-12;

test('numbers are the library\'s', {timeout: 600e3}, (t) => {
  const made = {};
  const states = {};
  for (const name of fs.readdirSync(joints)) {
    const file = path.join(joints, name);
    const text = fs.readFileSync(file, 'utf8');
    let joint = new contact.Joint(text);
    states[file] = statesOf(file, joint);
    if (joint.has_seat) joint = new contact.Joint(text, {'seat.left_out': true});
    made[file] = joint;
  }
  const [, python] = /^_Python_EXECUTABLE:INTERNAL=(.*)$/m.exec(
      fs.readFileSync(path.join(build, 'CMakeCache.txt'), 'utf8'));
  const native = JSON.parse(execFileSync(
      python, ['-W', 'ignore', path.join(__dirname, 'native.py')],
      {input: JSON.stringify(states), maxBuffer: 1e9,
       env: {...process.env, PYTHONPATH: path.join(build, 'python')}})
      .toString().replace(/\bNaN\b/g, 'null').replace(/-?Infinity/g, '1e999'));
  for (const [file, s] of Object.entries(states)) {
    const worst = {error: 0};
    const joint = made[file];
    const expected = native[file];
    const compare = (key, computed, of, i) => {
      const error = difference(key, computed, of, expected, i);
      if (error > worst.error) Object.assign(worst, {error, key, computed, of, i});
    };
    const axis = s.axis ?? undefined;
    s.reactions.forEach((reaction, i) => {
      const slip = joint.solve(reaction, s.rates[i], {axis});
      assert.strictEqual(slip.status === 'ok', expected.status[i] === 0, file);
      for (const key of s.keys) compare(key, slip[key], expected[key][i], i);
      compare('utilisation', joint.atRest(reaction, s.moments[i], {axis}).utilisation,
              expected.utilisation[i], i);
    });
    const columns = joint.solveRows(
        Float64Array.from(s.reactions.flat()), Float64Array.from(s.rates.flat()),
        {axis, keys: ['friction_moment', 'half_angle']});
    s.reactions.forEach((_, i) => {
      compare('friction_moment', [...columns.friction_moment.slice(3 * i, 3 * i + 3)],
              expected.friction_moment[i], i);
      compare('half_angle', columns.half_angle[i], expected.half_angle[i], i);
    });
    expected.step_moment.forEach((moment, i) => {
      const fresh = new contact.Joint(fs.readFileSync(file, 'utf8'),
                                      s.without_seat ? {'seat.left_out': true} : {});
      const step = fresh.step({reaction: s.reactions[i], angular_velocity: s.rates[i],
                               free: s.free[i], axis}, s.inertia);
      assert.strictEqual(step.holds, expected.step_holds[i], file);
      compare('step_moment', step.moment, moment, i);
      compare('step_rate', step.angular_velocity, expected.step_rate[i], i);
      fresh.free();
    });
    t.diagnostic(`${path.basename(file)}: ${worst.error.toExponential(1)} ${
        worst.key ?? ''}`);
    assert.ok(worst.error <= tolerance, JSON.stringify(worst));
  }
});

test('a contact at a rim is that of hinge-joint', () => {
  const text = fs.readFileSync(path.join(joints, 'hip_cup.toml'), 'utf8');
  const joint = new contact.Joint(text);
  const [row] = JSON.parse(execFileSync(path.join(build, 'bin/hinge-joint'), [
    path.join(joints, 'hip_cup.toml'), '--reaction-xyz', '1000,0,2000',
    '--rate-xyz', '0,1,0', '--format', 'json']));
  const slip = joint.solve([1000, 0, 2000], [0, 1, 0]);
  assert.strictEqual(slip.status, 'ok');
  const name = Object.keys(row).find((key) => key.startsWith('p_peak'));
  // The grid of a seat multiplies roundings: measured 5e-15.
  assert.ok(Math.abs(slip.peak_pressure / row[name] - 1) < 1e-12,
            `${slip.peak_pressure} ${row[name]}`);
});

const steel = {youngs_modulus_GPa: 200, poissons_ratio: 0.3};
const ball = {
  kind: 'ball', geometry: {radius_mm: 20, radial_clearance_um: 20},
  materials: {inner: steel, outer: steel}, friction: {coefficient: 0.1},
};

test('a resting joint stays at exactly 0, and lets go at its limit', () => {
  const joint = new contact.Joint(ball);
  const [reaction, still] = [[0, 0, 1000], [0, 0, 0]];
  const {utilisation} = joint.atRest(reaction, [1, 1, 1]);
  for (const [share, holds] of [[0.999999, true], [1.000001, false]]) {
    // The moment that stops `free` in one step, with unit inertia.
    const free = [1, 1, 1].map((x) => x * share / utilisation);
    const step = joint.step({reaction, angular_velocity: still, free},
                            [1, 0, 0, 0, 1, 0, 0, 0, 1]);
    assert.strictEqual(step.holds, holds);
    assert.strictEqual(step.angular_velocity.every((x) => x === 0), holds);
  }
});

test('what is refused says what is allowed', () => {
  const refused = (use, words) => assert.throws(use, (error) => {
    assert.ok(error instanceof Error && words.test(error.message), error.message);
    return true;
  });
  refused(() => new contact.Joint({...ball, geometry: {radius_mn: 20}}),
          /^unknown key .*radius_mn.* did you mean .radius_m/);
  refused(() => new contact.Joint('kind = "ball"\nradius = 1'), /^joint:2: /);
  refused(() => new contact.Joint(ball, {'geometry.radius_mm': -1}),
          /geometry.radius_mm.* -1 must be above 0/);
  const joint = new contact.Joint(ball);
  refused(() => joint.solve([0, 0, 1], [1, 0, 0], {keys: ['half_angel']}),
          /half_angel.*half_angle/);
  refused(() => joint.solve([1e3], [1, 0, 0]), /reaction must have 3 numbers, not 1/);
  refused(() => joint.atRest([0, 0, 1, 9], [1, 0, 0]), /must have 3 numbers, not 4/);
  refused(() => joint.solveRows([0, 0, 1, 0, 0, 2], new Array(12).fill(1)),
          /reactions and rates must have 12 numbers, not 6/);
  const mechanism = new contact.Mechanism([{joint, first: 0}], 3);
  refused(() => mechanism.weigh([1, 2, 3], [], [], 1e-3),
          /inertia must have 9 numbers, not 3/);
  refused(() => mechanism.begin([], [0, 0, 0], [0, 0, 0]),
          /starts, each of a joint, must have 1 numbers, not 0/);
  refused(() => mechanism.turn([0, 0, 0], [0]), /force must have 3 numbers, not 1/);
  mechanism.free();
  // The status is a word, whatever is asked for.
  assert.deepStrictEqual(joint.solve([0, 0, 1], [1, 0, 0], {keys: []}), {status: 'ok'});
  assert.deepStrictEqual(
      joint.solveRows([0, 0, 1], [1, 0, 0], {keys: ['status']}), {status: ['ok']});
  joint.free();
  refused(() => joint.solve([0, 0, 1], [1, 0, 0]), /must be other than NULL/);
  const notes = new contact.Joint(ball).notes([0, 0, 1e9], [1, 0, 0]);
  assert.ok(notes.length > 0 && notes.every((note) => note.length > 10), notes);
});

test('materials of files are there, numbers of every size too', () => {
  const joint = new contact.Joint({
    ...ball, materials: {pair: '../materials/cocr_uhmwpe.toml'},
    friction: {coefficient: 1e-7, adhesion_Pa: 0}});
  assert.ok(joint.effective_modulus > 1e9);
  const rigid = {youngs_modulus: Infinity, poissons_ratio: 0.3};
  new contact.Joint({...ball, materials: {inner: rigid, outer: steel}}).free();
});

test('joints that have gone leave no memory', () => {
  const use = () => {
    for (let i = 0; i < 300; ++i) {
      const joint = new contact.Joint(ball);
      joint.solve([0, 0, 1000], [1, 0, 0]);
      joint.free();
    }
    return process.memoryUsage().arrayBuffers;
  };
  const first = use();
  // Nothing but short-lived arrays of results.
  assert.ok(use() - first < 4e6);
});

test('it is packed in 1.2 MB, installed, and its example runs', (t) => {
  const work = fs.mkdtempSync(path.join(os.tmpdir(), 'npm-'));
  t.after(() => fs.rmSync(work, {recursive: true}));
  const npm = (...args) => execFileSync('npm', [...args, '--silent', '--offline'],
                                        {cwd: work, encoding: 'utf8'});
  const file = npm('pack', folder).trim();
  const {size} = fs.statSync(path.join(work, file));
  t.diagnostic(`${file}: ${size} bytes`);
  assert.ok(size <= 1.2e6, `${size} bytes`);
  fs.writeFileSync(path.join(work, 'package.json'), '{"private": true, "type": "module"}');
  npm('install', `./${file}`);
  const [, example] = /```js\n(.*?)```/s.exec(
      fs.readFileSync(path.join(folder, 'README.md'), 'utf8'));
  fs.writeFileSync(path.join(work, 'a.mjs'), example +
      'console.log(slip.friction_moment, slip.peak_pressure);');
  const said = execFileSync(process.execPath, ['a.mjs'], {cwd: work, encoding: 'utf8'});
  // M = f_M R rho; f_M of a dry pin lies a little above f0 = 0.1.
  const moment = Number(/-?\d[\d.e+-]*/.exec(said));
  assert.ok(moment < -10 && moment > -13, said);

  const compiler = path.resolve(__dirname, '../browser/node_modules/.bin/tsc');
  if (!fs.existsSync(compiler)) {
    t.diagnostic('types are not checked: typescript is missing (npm ci)');
    return;
  }
  for (const name of ['user.ts', 'mistakes.ts']) {
    fs.copyFileSync(path.join(__dirname, name), path.join(work, name));
  }
  const check = (name) => spawnSync(process.execPath, [
    fs.realpathSync(compiler), '--strict', '--noEmit', '--module', 'nodenext',
    '--target', 'es2022', '--lib', 'es2022,dom', name],
      {cwd: work, encoding: 'utf8'}).stdout;
  assert.strictEqual(check('user.ts'), '');
  // Every line with a mistake is found, and no other.
  const wrong = fs.readFileSync(path.join(work, 'mistakes.ts'), 'utf8').split('\n')
      .flatMap((line, i) => /\/\/ wrong$/.test(line) ? [i + 1] : []);
  const found = [...check('mistakes.ts').matchAll(/^mistakes\.ts\((\d+),/gm)]
      .map((match) => Number(match[1]));
  assert.deepStrictEqual([...new Set(found)], wrong);
});

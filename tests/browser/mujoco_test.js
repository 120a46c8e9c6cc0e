// A pin's load law in MuJoCo 3, as simulator.md has it: frictionloss is set to
// it at each step, and two attributes make its constraint hold.
'use strict';
const assert = require('node:assert');
const {execFileSync} = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const {before, test} = require('node:test');

const degree = Math.PI / 180;
const stiff =
    'solimpfriction="0.9999 0.9999 0.001" solreffriction="0.002 1"';
let mujoco;
let friction;

before(async () => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'mujoco-'));
  const joint = path.join(folder, 'pin.toml');
  const steel = 'youngs_modulus_GPa = 200\npoissons_ratio = 0.3\n';
  fs.writeFileSync(joint, `name = "pendulum"
kind = "pin"
[geometry]
radius_mm = 20
radial_clearance_um = 20
length_mm = 40
[materials.inner]
${steel}[materials.outer]
${steel}[friction]
coefficient = 0.15
adhesion_Pa = 2e4
`);
  const law = path.join(folder, 'law.mjs');
  execFileSync(`${process.env.CONTACT_BUILD}/bin/hinge-joint`, [
    '--joint', joint, '--reaction', '5,50000', '--kernel', 'js',
    '--kernel-error', '1e-6', '--output', law,
  ]);
  ({friction} = await import(law));
  mujoco = await (await import('mujoco-js')).default();
  fs.rmSync(folder, {recursive: true});
});

// A body on a hinge about y, with its data.
function hinge(joint, body, more) {
  mujoco.FS.writeFile('model.xml', `<mujoco>
    <option timestep="0.001" integrator="implicitfast"/><worldbody>
    <body ${body}><joint type="hinge" axis="0 1 0" ${joint}/>${more}</body>
    </worldbody></mujoco>`);
  const m = mujoco.MjModel.loadFromXML('model.xml');
  return [m, new mujoco.MjData(m)];
}

// An arm of 5 kg that hangs 0.4 m below the pin, let go at 1 rad, for 60 s.
function swing(follows) {
  const across = 0.9 - 5 * 0.4 * 0.4;
  const [m, d] = hinge(
      `frictionloss="${friction(5 * 9.81)[0]}" ${stiff}`,
      `euler="0 ${1 / degree} 0"`, `<inertial pos="0 0 -0.4" mass="5"
        diaginertia="${across} ${across} 0.02"/>`);
  const run = {turns: [], rest: 0};
  let last = 0;
  let before = 0;
  for (let i = 0; i < 60000; ++i) {
    mujoco.mj_step(m, d);
    if (follows) {
      mujoco.mj_rnePostConstraint(m, d);
      m.dof_frictionloss[0] = friction(Math.hypot(...d.cfrc_int.slice(9)))[0];
    }
    const rate = d.qvel[0];
    const angle = (d.qpos[0] + 1) / degree;
    if (rate * last < 0 && Math.abs(rate - last) > 1e-6) run.turns.push(angle);
    if (Math.abs(rate) > 1e-4) run.rest = i * 1e-3;
    if (i === 50000) before = angle;
    run.creep = Math.abs(angle - before) * 6;  // of 10 s, deg a minute
    last = rate;
  }
  return run;
}

// By step() of libcontact at 1 ms, and by Runge-Kutta with events 3.390 deg and
// 35.643 s.
test('a pendulum whose friction follows its load', () => {
  const run = swing(true);
  assert.ok(Math.abs(Math.abs(run.turns[47]) - 3.391) < 2e-3, run.turns[47]);
  assert.ok(Math.abs(run.rest - 35.64) < 0.01, run.rest);
  assert.ok(run.creep < 1e-4, run.creep);
});

test('one that does not turns 2.6 times as far after 48 turns', () => {
  const turn = Math.abs(swing(false).turns[47]);
  assert.ok(Math.abs(turn - 8.78) < 0.01, turn);
});

test('a held arm creeps as the page says', () => {
  const [mass, arm] = [5, 0.5];
  const torque = mass * 9.81 * arm;
  const inertia = mass * (arm * arm + 0.4 * 0.02 * 0.02);
  for (const [more, d0, dWidth, time] of [
    ['', 0.9, 0.95, 0.02], [stiff, 0.9999, 0.9999, 0.002]]) {
    const [m, d] = hinge(
        `frictionloss="${torque / 0.8}" ${more}`, '',
        `<geom type="sphere" size="0.02" pos="${arm} 0 0" mass="${mass}"/>`);
    const angles = [2000, 5000].map((steps) => {
      for (let i = 0; i < steps; ++i) mujoco.mj_step(m, d);
      return d.qpos[0];
    });
    const rate = (angles[1] - angles[0]) / 5;
    const said = (1 - d0) / d0 * torque / inertia * dWidth * time / 2;
    assert.ok(Math.abs(rate / said - 1) < 0.01, `${rate} ${said}`);
  }
});

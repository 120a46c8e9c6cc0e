// The package's example in MuJoCo 3: the pendulum of pendulum.md rests when it
// does with the adapter in C++, and then no bit changes.
//   CONTACT_NPM  the package's folder
'use strict';
const assert = require('node:assert');
const path = require('node:path');
const {createRequire} = require('node:module');
const {before, test} = require('node:test');
const {pathToFileURL} = require('node:url');

const folder = path.resolve(process.env.CONTACT_NPM);
const at = (name) => pathToFileURL(path.join(folder, name));
const {resolve} = createRequire(path.resolve(__dirname, '../browser/package.json'));

let mujoco;
let contact;
let HingeFriction;
before(async () => {
  contact = await (await import(at('index.js'))).load();
  ({HingeFriction} = await import(at('examples/mujoco.js')));
  mujoco = await (await import(pathToFileURL(resolve('mujoco-js')))).default();
});

function model(text) {
  mujoco.FS.writeFile('model.xml', `<mujoco>${text}</mujoco>`);
  const m = mujoco.MjModel.loadFromXML('model.xml');
  return [m, new mujoco.MjData(m)];
}
const steel = {youngs_modulus_GPa: 200, poissons_ratio: 0.3};
const ball = () => new contact.Joint({
  kind: 'ball', geometry: {radius_mm: 20, radial_clearance_um: 20},
  materials: {inner: steel, outer: steel},
  friction: {coefficient: 0.15, adhesion_Pa: 2e4},
  half_angle: {law: 'tanh'}, pressure: {law: 'cosine'},
});

// Of the adapter in C++ on MuJoCo 2.2.2: hosts.md.
for (const [dt, rest] of [[1e-3, 43.607], [5e-4, 43.968], [2.5e-4, 44.157]]) {
  test(`a pendulum rests after ${rest} s by steps of ${dt * 1e3} ms`, () => {
    const [m, d] = model(`<option timestep="${dt}" integrator="Euler"
        gravity="0 0 -9.81"/><worldbody><body><joint name="j" type="ball"/>
        <inertial pos="0 0 -0.4" mass="5" diaginertia="0.1 0.1 0.02"/></body>
        </worldbody>`);
    const [c, s] = [Math.cos(1), Math.sin(1)];
    d.qpos.set([Math.cos(0.5), Math.sin(0.5), 0, 0]);
    d.qvel.set([0, c + s * 0.5, -s + c * 0.5]);
    const friction = new HingeFriction(mujoco, m, contact);
    friction.add('j', ball());
    let steps = 0;
    do {
      friction.step(d);
    } while (d.qvel.some((x) => x !== 0) && ++steps < 60 / dt);
    assert.ok(Math.abs(steps * dt - rest) < 1e-3, `${steps * dt}`);
    const angles = Array.from(d.qpos);
    while (d.time < 60) friction.step(d);
    assert.deepStrictEqual(Array.from(d.qpos), angles);
  });
}

test('a loop that is closed rests in a few turns', () => {
  const link = (name, x, more) => `<body pos="${x} 0 0">
      <joint name="${name}" type="hinge" axis="0 1 0"/>
      <geom type="capsule" fromto="0 0 0 0 0 -0.5" size="0.02" mass="1"/>${more}</body>`;
  const [m, d] = model(`<option timestep="0.001" integrator="Euler"/>
      <worldbody>${link('a', 0, '<body name="end" pos="0 0 -0.5"/>')}
      ${link('b', 0.3, '<body name="other" pos="0 0 -0.5"/>')}</worldbody>
      <equality><connect body1="end" body2="other" anchor="0 0 0"/></equality>`);
  const friction = new HingeFriction(mujoco, m, contact);
  const pin = new contact.Joint({
    kind: 'pin', geometry: {radius_mm: 20, radial_clearance_um: 20, length_mm: 40},
    materials: {inner: steel, outer: steel}, friction: {coefficient: 0.15}});
  friction.add('a', pin);
  friction.add('b', pin);
  let turns = 0;
  while (d.time < 10) {
    friction.step(d);
    turns = Math.max(turns, friction.turns);
  }
  assert.ok(d.qvel.every((x) => x === 0), d.qvel);
  assert.ok(turns <= 5, `${turns} turns`);
  assert.throws(() => friction.add('none', pin), /"none" must be a joint/);
});

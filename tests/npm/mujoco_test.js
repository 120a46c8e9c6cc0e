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

// HoldsALoop of tests/hosts/mujoco_test.cpp: an equality closes the linkage,
// friction holds it 0.01 deg off the vertical.
test('a four-bar linkage rests, and no bit changes', () => {
  const [m, d] = model(`<option timestep="0.001" integrator="Euler"
      gravity="0.002 0 -9.81"/><worldbody>
      <body name="a"><joint name="0" type="hinge" axis="0 1 0"/>
        <inertial mass="1" pos="0 0 -.25" diaginertia=".02 .02 .002"/>
        <body name="b" pos="0 0 -.5"><joint name="1" type="hinge" axis="0 1 0"/>
          <inertial mass="1" pos=".25 0 0" diaginertia=".002 .02 .02"/></body>
      </body>
      <body name="c" pos=".5 0 0"><joint name="2" type="hinge" axis="0 1 0"/>
        <inertial mass="1" pos="0 0 -.25" diaginertia=".02 .02 .002"/></body>
      </worldbody><equality><connect body1="b" body2="c" anchor=".5 0 0"/>
      </equality>`);
  const friction = new HingeFriction(mujoco, m, contact);
  const pin = new contact.Joint({
    kind: 'pin',
    geometry: {radius_mm: 20, radial_clearance_um: 20, length_mm: 30},
    materials: {inner: steel, outer: steel}, friction: {coefficient: 0.15}});
  for (const name of ['0', '1', '2']) friction.add(name, pin);
  for (let i = 0; i < 2000; ++i) friction.step(d);
  const angles = Array.from(d.qpos);
  assert.ok(Math.abs(angles[0]) < 0.1, angles);
  for (let i = 0; i < 6000; ++i) friction.step(d);
  assert.deepStrictEqual(Array.from(d.qpos), angles);
  assert.throws(() => friction.add('none', pin), /"none" must be a joint/);
});

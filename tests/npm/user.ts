import {ContactError, load, type JointFile, type Vector3} from 'libcontact';

const {Joint, Mechanism, quantities} = await load();
const steel = {youngs_modulus_GPa: 210, poissons_ratio: 0.3};
const file: JointFile = {
  kind: 'ball',
  geometry: {radius_mm: 20, radial_clearance_um: 20},
  materials: {inner: steel, outer: steel},
  friction: {coefficient: 0.1, adhesion_Pa: 2e4},
  wall: {backing: 'rigid', layer: [{thickness_mm: 2, ...steel}]},
  half_angle: {law: 'exact'},
};
const joint = new Joint(file, {'geometry.radius_mm': 25});
const slip = joint.solve([0, 0, 1e3], new Float64Array([1, 0, 0]));
const moment: Vector3 = slip.friction_moment;
const sliding: boolean = slip.state === 'sliding';
const rows = joint.solveRows(new Float64Array(6), new Float64Array(6),
                             {keys: ['half_angle'], warm: true});
const angles: Float64Array = rows.half_angle;
const rest = joint.atRest([0, 0, 1e3], [1, 0, 0]);
const peak: number = joint.patch(1e3).peak_pressure;
const step = joint.step({reaction: [0, 0, 1e3], angular_velocity: [1, 0, 0],
                         free: [1, 0, 0]}, [1, 0, 0, 0, 1, 0, 0, 0, 1]);
const mechanism = new Mechanism([{joint, first: 0}], 3);
mechanism.weigh([1, 0, 0, 0, 1, 0, 0, 0, 1], [], [], 1e-3);
console.log(moment, sliding, angles, rest.holds, peak, step.moment,
            quantities.solution[0]?.meaning, joint.notes(), ContactError);

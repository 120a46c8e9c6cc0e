import {load} from 'libcontact';

const {Joint} = await load();
new Joint({kind: 'ball', geometry: {radius_mn: 20}}); // wrong
new Joint({geometry: {radius_mm: 20}}); // wrong
const joint = new Joint('kind = "ball"');
joint.solve([0, 0, 1e3], 1); // wrong
joint.solve([0, 0, 1e3], [1, 0, 0], {keys: ['half_angel']}); // wrong
joint.solve([0, 0, 1e3], [1, 0, 0]).state === 'slipping'; // wrong
joint.solve([0, 0, 1e3], [1, 0, 0], {keys: ['half_angle']}).peak_pressure; // wrong
joint.atRest([0, 0, 1e3], [1, 0, 0]).utilization; // wrong
joint.step({reaction: [0, 0, 1e3], free: [1, 0, 0]}, []); // wrong

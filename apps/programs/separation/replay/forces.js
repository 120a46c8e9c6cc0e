// Forces of the case: arrows where they enter bodies, lines from one body to the
// other where they act between two, arrows with two heads for moments.

class ForceMarks {
  constructor(picture) {
    this.picture = picture;
    this.most = {applied: 0, between: 0, drive: 0};
    this.marks = take.forces ? data.forces.map((force, i) => {
      const kind = force.other === undefined ? 'applied' : 'between';
      const most = mostOf(i);
      this.most[kind] = Math.max(this.most[kind], most.force);
      this.most.drive = Math.max(this.most.drive, most.moment);
      const colour = colours[kind];
      return {
        force, kind,
        arrow: picture.addArrow(colour, 1),
        opposite: kind === 'between' && picture.addArrow(colour, 1),
        line: kind === 'between' && picture.addLine(colour, 1),
        moment: most.moment > 0 && picture.addArrow(colours.drive, 2),
      };
    }) : [];
  }

  set() {
    const shown = at('show_forces').checked;
    this.marks.forEach((mark, i) => this.setMark(mark, shown && take.force(i)));
  }

  setMark({force, kind, arrow, opposite, line, moment}, acts) {
    const {picture, most} = this;
    const from = picture.place(force.body, force.point);
    const way = new THREE.Vector3(...(acts ? acts.force : [0, 0, 0]));
    picture.setArrow(arrow, way.length() > 0, from, way, most[kind]);
    if (moment) {
      const turn = new THREE.Vector3(...(acts ? acts.moment : [0, 0, 0]));
      picture.setArrow(moment, turn.length() > 0, from, turn, most.drive);
    }
    if (!line) return;
    const to = picture.place(force.other, force.other_point);
    picture.setArrow(opposite, way.length() > 0, to, way.clone().negate(),
                     most[kind]);
    line.visible = Boolean(acts);
    picture.stretch(line, from, to, 0.004 * picture.size);
  }
}

// A nozzle and a plume have length 1 along y, from the throat on.
const bell = new THREE.CylinderBufferGeometry(1, 0.5, 1, 24, 1, true);
bell.translate(0, 0.5, 0);
const flame = new THREE.ConeBufferGeometry(1, 1, 24, 1, true);
flame.translate(0, 0.5, 0);

// The engines: a nozzle at each point of a body with a thrust, on the body, and
// a plume of a length in proportion to all thrust there.
class Engines {
  constructor(picture) {
    this.size = picture.size;
    this.all = [];
    if (!take.forces) return;
    data.forces.forEach((force, i) => {
      if (!force.exhaust) return;
      const place = `${force.body} ${force.point} ${force.exhaust}`;
      const there = this.all.find((engine) => engine.place === place);
      if (there) there.forces.push(i);
      else this.all.push(this.engine(force, i, place, picture));
    });
    this.most = Math.max(...this.all.map(({forces}) => forces.reduce(
        (sum, i) => sum + mostOf(i).force, 0)));
  }

  engine({body, point, exhaust}, number, place, picture) {
    const box = new THREE.Box3().setFromPoints(picture.corners[body]);
    const {x, y, z} = box.getSize(new THREE.Vector3());
    const radius = Math.min(0.2 * Math.min(x, y, z), 0.03 * this.size);
    const group = new THREE.Group();
    group.position.set(...point);
    group.quaternion.setFromUnitVectors(
        new THREE.Vector3(0, 1, 0), new THREE.Vector3(...exhaust));
    const part = (shape, material, width) => {
      const mesh = new THREE.Mesh(shape, material);
      mesh.scale.set(width, 2 * radius, width);
      group.add(mesh);
      return mesh;
    };
    part(bell, new THREE.MeshLambertMaterial(
        {color: new THREE.Color('#55585c').convertSRGBToLinear(),
         side: THREE.DoubleSide}), radius);
    const plumes = [['#ff8c1a', 0.5, 1], ['#ffe08a', 0.9, 0.5]].map(
        ([colour, opacity, width]) => part(flame, new THREE.MeshBasicMaterial({
          color: new THREE.Color(colour).convertSRGBToLinear(), opacity,
          transparent: true, depthWrite: false}), width * radius));
    for (const plume of plumes) plume.position.y = 2 * radius;
    picture.bodies[body].add(group);
    return {place, forces: [number], plumes, length: 0};
  }

  set() {
    for (const engine of this.all) {
      const thrust = engine.forces.reduce((sum, i) => {
        const acts = take.force(i);
        return sum + (acts ? Math.hypot(...acts.force) : 0);
      }, 0);
      engine.length = 0.3 * this.size * thrust / this.most;
      engine.plumes.forEach((plume, i) => {
        plume.visible = thrust > 0;
        plume.scale.y = engine.length * (i === 0 ? 1 : 0.5) + 1e-9;
      });
    }
  }
}

// The largest force and moment of all rows.
function mostOf(number) {
  const most = {force: 0, moment: 0};
  for (let i = 6 * number; i < take.forces.length;
    i += 6 * data.forces.length) {
    const [x, y, z, u, v, w] = take.forces.subarray(i, i + 6);
    if (Number.isNaN(x)) continue;
    most.force = Math.max(most.force, Math.hypot(x, y, z));
    most.moment = Math.max(most.moment, Math.hypot(u, v, w));
  }
  return most;
}

// The page of a replay (page.html): the bodies in motion, curves, tables. All
// text goes into the page as text, never as markup.
(() => {
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const at = (id) => document.getElementById(id);
const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
const released = 3;
const modes = ['sliding', 'resting', 'locked', 'released'];

function make(tag, parent, text, className) {
  const element = document.createElement(tag);
  if (text !== undefined) element.textContent = text;
  if (className) element.className = className;
  if (parent) parent.append(element);
  return element;
}

function bytes(base64) {
  const text = atob(base64);
  const result = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) result[i] = text.charCodeAt(i);
  return result;
}

// 4 digits, with a prefix for the units that take one: "1.234 MN".
function show(value, unit) {
  if (!Number.isFinite(value)) return '–';
  const prefixes = {9: 'G', 6: 'M', 3: 'k', 0: '', '-3': 'm', '-6': 'µ'};
  if (!/^(N|N m|Pa|J|m)$/.test(unit)) {
    return `${round(value)}${unit ? ' ' + unit : ''}`;
  }
  const largest = unit === 'm' ? 0 : 9;
  const exponent = value === 0 ? 0 : Math.min(largest, Math.max(
      -6, 3 * Math.floor(Math.log10(Math.abs(value)) / 3)));
  return `${round(value / 10 ** exponent)} ${prefixes[exponent]}${unit}`;
}
const round = (value) => String(Number(value.toPrecision(4)));
const seconds = (time) => `${time.toFixed(3)} s`;

// A run: its rows under the names of the history's columns.
class Take {
  constructor(json) {
    this.name = json.name;
    this.nodes = json.nodes;
    this.summary = json.summary;
    this.time = new Float64Array(bytes(json.time).buffer);
    this.packed = json.columns;
    this.columns = new Map();
    this.nearest =
        json.nearest && new Float32Array(bytes(json.nearest).buffer);
    this.row = 0;
    this.part = 0;
  }
  get start() { return this.time[0]; }
  get end() { return this.time[this.time.length - 1]; }
  column(name) {
    if (!this.columns.has(name)) {
      const packed = this.packed[name];
      this.columns.set(
          name, packed && new Float32Array(bytes(packed).buffer));
    }
    return this.columns.get(name);
  }
  // The last row at this time or before it, and how far it is to the next.
  go(time) {
    let low = 0;
    let high = this.time.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.time[middle] <= time) low = middle; else high = middle;
    }
    this.row = low;
    const rest = this.time[low + 1] - this.time[low];
    this.part = rest > 0 ? (time - this.time[low]) / rest : 0;
  }
  at(name) {
    const column = this.column(name);
    if (!column) return NaN;
    const from = column[this.row];
    return this.part > 0 ?
        from + this.part * (column[this.row + 1] - from) : from;
  }
  mode(body) {
    const column = this.column(`${body.column}.mode`);
    return column ? column[this.row] : NaN;
  }
  // Until its hinge breaks.
  held(body) { return this.mode(body) < released; }
}

const takes = data.takes.map((json) => new Take(json));
const take = takes[0];
const hinged = data.bodies.filter((body) => body.hinge);
const events = take.summary.events;
const pairName = (pair) =>
    data.pairs[pair].map((body) => data.bodies[body].name).join(', ');
const pairColumn = (pair) => 'clearance.' +
    data.pairs[pair].map((body) => data.bodies[body].column).join('.') + '_m';

function largest(name) {
  let result = 0;
  for (const body of hinged) {
    for (const x of take.column(`${body.column}.${name}`)) {
      if (x > result) result = x;
    }
  }
  return result;
}

// ---------------------------------------------------------------- the picture

// Dark to light, as the legend: of 0 to 1.
const scale = ['#440154', '#3b528b', '#21918c', '#5ec962', '#fde725'];
function scaleColour(part, into) {
  const place = Math.min(0.9999, Math.max(0, part)) * (scale.length - 1);
  const i = Math.floor(place);
  return into.set(scale[i]).lerp(new THREE.Color(scale[i + 1]), place - i);
}

// Of glTF's animations, in three.js.
const properties =
    {translation: 'position', rotation: 'quaternion', scale: 'scale'};

class Picture {
  constructor(canvas) {
    this.renderer = new THREE.WebGLRenderer(
        {canvas, antialias: true, alpha: true});
    this.renderer.gammaOutput = true;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.size = data.size;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(
        32, 1, 0.01 * this.size, 400 * this.size);
    this.scene.add(this.camera);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x667788, 0.75));
    const lamp = new THREE.DirectionalLight(0xffffff, 0.75);
    lamp.position.set(0.6, 1, 0.8);
    this.camera.add(lamp);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.enableDamping = false;
    this.follow = 0;
    this.target = new THREE.Vector3();
  }

  async load() {
    const gltf = await new Promise((resolve, reject) =>
        new THREE.GLTFLoader().parse(bytes(data.glb).buffer, '', resolve,
                                     reject));
    this.root = gltf.scene.children[0];
    this.scene.add(gltf.scene);
    const node = (i) => gltf.parser.getDependency('node', i);
    this.tracks = [];
    // One track for each channel, in the same order: nodes by their numbers,
    // since names may be alike.
    const [motion] = gltf.animations;
    const [channels] = (gltf.parser.json.animations || []).map(
        (animation) => animation.channels);
    for (let i = 0; motion && i < motion.tracks.length; ++i) {
      const {node: number, path} = channels[i].target;
      const object = await node(number);
      this.tracks.push({
        object,
        property: object[properties[path]],
        values: motion.tracks[i].createInterpolant(),
      });
    }
    this.bodies = [];
    for (const nodes of takes[0].nodes) this.bodies.push(await node(nodes[0]));
    this.addMarks();
    this.resize();
    this.fit();
  }

  // What is drawn beside the bodies, in inertial axes about the carrier.
  addMarks() {
    const top = (colour) => new THREE.MeshBasicMaterial(
        {color: colour, depthTest: false, transparent: true});
    const shaft = new THREE.CylinderBufferGeometry(1, 1, 1, 12);
    shaft.translate(0, 0.5, 0);
    const head = new THREE.ConeBufferGeometry(1, 1, 16);
    head.translate(0, -0.5, 0);
    const add = (geometry, material, order) => {
      const mesh = new THREE.Mesh(geometry, material);
      mesh.renderOrder = order;
      mesh.frustumCulled = false;
      this.root.add(mesh);
      return mesh;
    };
    const arrow = (colour, heads) => {
      const material = top(colour);
      return {shaft: add(shaft, material, 3), heads: Array.from(
          {length: heads}, () => add(head, material, 3))};
    };
    this.hinges = hinged.map((body) => ({
      body,
      object: this.bodies[data.bodies.indexOf(body)],
      reaction: arrow('#c0143c', 1),
      moment: arrow('#7b3fbf', 2),
      patch: add(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial(
          {side: THREE.DoubleSide, depthTest: false, transparent: true,
           opacity: 0.92}), 2),
    }));
    this.patches = new Map();
    this.most = {reaction: largest('reaction_N'),
                 moment: largest('friction_moment_N_m'),
                 pressure: largest('peak_pressure_Pa')};
    this.line = add(shaft, top('#e0218a'), 4);
    this.line.visible = false;
  }

  // A cap of a ball about y, or a strip of a pin along z, of a half-angle in
  // whole degrees.
  patch(degrees, pin) {
    const key = pin ? -degrees - 1 : degrees;
    if (!this.patches.has(key)) {
      const radius = 0.035 * this.size;
      const t = degrees * Math.PI / 180;
      let shape;
      if (pin) {
        shape = new THREE.CylinderBufferGeometry(
            radius, radius, 2 * radius, 24, 1, true, -t, 2 * t);
        shape.rotateX(Math.PI / 2);  // the axis to z, its middle to -y
        shape.rotateZ(Math.PI);
      } else {
        shape = new THREE.SphereBufferGeometry(
            radius, 32, 12, 0, 2 * Math.PI, 0, t);
      }
      this.patches.set(key, shape);
    }
    return this.patches.get(key);
  }

  set(time) {
    for (const {object, property, values} of this.tracks) {
      property.fromArray(values.evaluate(time));
      object.visible = object.scale.x > 0;
    }
    for (const hinge of this.hinges) this.setHinge(hinge);
    this.setLine();
    if (this.follow >= 0) this.setTarget();
  }

  vector(body, quantity, unit, into) {
    return into.set(...['x', 'y', 'z'].map(
        (axis) => take.at(`${body.column}.${quantity}_${axis}_${unit}`)));
  }

  setHinge(hinge) {
    const {body, object, patch} = hinge;
    const on = at('show_forces').checked && take.held(body);
    hinge.centre = new THREE.Vector3(...body.hinge.point)
        .applyQuaternion(object.quaternion).add(object.position);
    const force = this.vector(body, 'reaction', 'N', new THREE.Vector3());
    const moment =
        this.vector(body, 'friction_moment', 'N_m', new THREE.Vector3());
    this.setArrow(hinge.reaction, on, hinge.centre, force, this.most.reaction);
    this.setArrow(hinge.moment, on && moment.length() > 0, hinge.centre, moment,
                  this.most.moment);
    this.setPatch(hinge, on, force, patch);
  }

  setPatch({body, centre}, on, force, patch) {
    const angle = take.at(`${body.column}.theta0_deg`);
    patch.visible = on && angle > 0 && force.length() > 0;
    if (!patch.visible) return;
    const pin = body.hinge.axis !== undefined;
    patch.geometry = this.patch(Math.max(1, Math.round(angle)), pin);
    patch.position.copy(centre);
    // Towards the side on which the inner body is pressed.
    const up = force.clone().multiplyScalar(
        body.hinge.inner === 'carrier' ? 1 : -1);
    let along = new THREE.Vector3(0, 0, 1);
    if (pin) {
      along = new THREE.Vector3(...body.hinge.axis)
          .applyQuaternion(this.bodies[0].quaternion);
      up.addScaledVector(along, -up.dot(along));
    } else if (Math.abs(up.z) > 0.9 * up.length()) {
      along.set(1, 0, 0);
    }
    up.normalize();
    const across = new THREE.Vector3().crossVectors(up, along).normalize();
    along.crossVectors(across, up);
    patch.quaternion.setFromRotationMatrix(
        new THREE.Matrix4().makeBasis(across, up, along));
    const pressure = take.at(`${body.column}.peak_pressure_Pa`);
    scaleColour(pressure / this.most.pressure, patch.material.color);
    patch.material.color.convertSRGBToLinear();
  }

  setArrow({shaft, heads}, on, from, vector, most) {
    for (const part of [shaft, ...heads]) part.visible = on && most > 0;
    if (!shaft.visible) return;
    const length = 0.42 * this.size * vector.length() / most;
    const headLength = Math.min(0.035 * this.size, 0.6 * length / heads.length);
    const width = 0.3 * headLength;
    const way = vector.clone().normalize();
    const turn = new THREE.Quaternion().setFromUnitVectors(
        new THREE.Vector3(0, 1, 0), way);
    shaft.position.copy(from);
    shaft.quaternion.copy(turn);
    shaft.scale.set(0.3 * width + 1e-9, Math.max(1e-9, length - headLength),
                    0.3 * width + 1e-9);
    heads.forEach((head, i) => {
      head.position.copy(from)
          .addScaledVector(way, length - 0.85 * i * headLength);
      head.quaternion.copy(turn);
      head.scale.set(width + 1e-9, headLength + 1e-9, width + 1e-9);
    });
  }

  // Between the two bodies that are nearest, by the points of the last row.
  setLine() {
    this.gap = undefined;
    const points = take.nearest;
    const i = 7 * take.row;
    this.line.visible =
        at('show_distance').checked && points !== undefined && points[i] >= 0;
    if (!this.line.visible) return;
    const ends = data.pairs[points[i]].map((body, j) =>
        new THREE.Vector3().fromArray(points, i + 1 + 3 * j)
            .applyQuaternion(this.bodies[body].quaternion)
            .add(this.bodies[body].position));
    const span = ends[1].clone().sub(ends[0]);
    this.line.position.copy(ends[0]);
    this.line.quaternion.setFromUnitVectors(
        new THREE.Vector3(0, 1, 0), span.clone().normalize());
    const width = 0.0018 * this.size;
    this.line.scale.set(width, Math.max(1e-9, span.length()), width);
    this.gap = {pair: points[i], middle: ends[0].lerp(ends[1], 0.5)};
  }

  setTarget() {
    const place = this.root.localToWorld(
        this.bodies[this.follow].position.clone());
    this.camera.position.add(place).sub(this.target);
    this.controls.target.add(place).sub(this.target);
    this.target.copy(place);
  }

  resize() {
    const {clientWidth, clientHeight} = at('scene');
    this.width = clientWidth;
    this.height = clientHeight;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
  }

  // All bodies, as they are now, from where the camera is.
  fit() {
    this.root.updateWorldMatrix(true, true);
    const boxes = this.bodies.map(
        (body) => new THREE.Box3().setFromObject(body));
    const box = boxes.reduce((all, one) => all.union(one), new THREE.Box3());
    const corners = boxes.flatMap(({min, max}) => [0, 1, 2, 3, 4, 5, 6, 7].map(
        (k) => new THREE.Vector3(k & 1 ? min.x : max.x, k & 2 ? min.y : max.y,
                                 k & 4 ? min.z : max.z)));
    const from = this.camera.position.length() > 0 ?
        this.camera.position.clone().sub(this.controls.target).normalize() :
        new THREE.Vector3(-0.5, 0.5, 1).normalize();
    box.getCenter(this.controls.target);
    let distance = 4 * box.getBoundingSphere(new THREE.Sphere()).radius;
    // Nearer, until they fill most of the picture.
    for (let i = 0; i < 4; ++i) {
      this.camera.position.copy(this.controls.target)
          .addScaledVector(from, distance);
      this.controls.update();
      this.camera.updateMatrixWorld();
      const reach = corners.map((corner) => corner.clone().project(this.camera))
          .map((p) => Math.max(Math.abs(p.x), Math.abs(p.y)));
      distance *= Math.max(...reach) / 0.9;
    }
  }

  turn(across, up) {
    const way = this.camera.position.clone().sub(this.controls.target);
    const ball = new THREE.Spherical().setFromVector3(way);
    ball.theta += across;
    ball.phi += up;
    ball.makeSafe();
    this.camera.position.copy(this.controls.target)
        .add(way.setFromSpherical(ball));
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor)
        .add(this.controls.target);
  }

  // Where a point of the root's axes is in the picture, px; below the middle
  // of the screen's depth it is behind the camera.
  project(point) {
    const p = this.root.localToWorld(point.clone()).project(this.camera);
    return {x: (p.x + 1) / 2 * this.width, y: (1 - p.y) / 2 * this.height,
            visible: p.z < 1};
  }

  draw() {
    this.controls.update();
    this.renderer.render(this.scene, this.camera);
  }
}

// Names of bodies and the smallest distance, over the picture.
class Labels {
  constructor(picture) {
    this.picture = picture;
    this.names = data.bodies.map((body) => {
      const label = make('div', at('labels'), body.name, 'body');
      label.style.borderColor = body.colour;
      return label;
    });
    this.distance = make('div', at('labels'), '', 'distance');
  }
  place() {
    const {picture} = this;
    const placed = [];
    const move = (label, point, on, down) => {
      const {x, y, visible} = on ? picture.project(point) : {visible: false};
      label.hidden = !visible;
      if (!visible) return;
      // Below those that are in its place.
      const width = label.textContent.length * 7 + 14;
      const here = {x, y: y + down, width};
      const covers = (other) => Math.abs(here.y - other.y) < 16 &&
          2 * Math.abs(x - other.x) < width + other.width;
      for (let tries = 0; tries < 6 && placed.some(covers); ++tries) {
        here.y += 16;
      }
      placed.push(here);
      label.style.transform = `translate(${x.toFixed(1)}px, ` +
          `${here.y.toFixed(1)}px) translate(-50%, -50%)`;
    };
    const {gap} = picture;
    if (gap) {
      const text = show(take.at(pairColumn(gap.pair)), 'm');
      if (this.distance.textContent !== text) this.distance.textContent = text;
    }
    move(this.distance, gap && gap.middle, gap !== undefined, -16);
    const named = at('show_names').checked;
    this.names.forEach((label, i) =>
        move(label, picture.bodies[i].position, named, 16));
  }
}

function addLegend({most}) {
  const line = (text) => make('p', at('legend'), text);
  if (hinged.length === 0) return;
  const entry = (mark, colour, text) => {
    const p = line('');
    make('b', p, mark).style.color = colour;
    p.append(text);
  };
  entry('→', '#d0204a', `reaction, up to ${show(most.reaction, 'N')}`);
  if (!(most.moment > 0)) return;
  entry('↠', '#8d55cf', `friction, up to ${show(most.moment, 'N m')}`);
  const p = line('pressure 0');
  make('i', p);
  p.append(show(most.pressure, 'Pa'));
}

// ----------------------------------------------------------------- the curves

const graphs = [];
// The legend sets style attributes, which the page's policy forbids.
Dygraph.PLUGINS =
    Dygraph.PLUGINS.filter((plugin) => plugin !== Dygraph.Plugins.Legend);

// A curve of each run; NaN leaves a gap.
function hingeCurves(quantity, dashed) {
  return takes.flatMap((run, k) => hinged.map((body) => {
    const values = run.column(`${body.column}.${quantity}`);
    const mode = run.column(`${body.column}.mode`);
    const ends = dashed ? 2 : released;
    return {run, colour: body.colour, faint: k > 0, dashed,
            at: (i) => (dashed ? mode[i] === ends : mode[i] < ends) ?
                values[i] : null};
  }));
}

function plainCurves(list) {
  return takes.flatMap((run, k) => list.map(([name, colour]) => {
    const values = run.column(name);
    return {run, colour, faint: k > 0, at: (i) => values[i]};
  }));
}

// Rows of all runs under one another: each has times of its own. Of rows too
// many to be told apart there are two of each so many: with the least and the
// largest value of each curve, whichever is first.
function rowsOf(curves) {
  const most = 1500;
  const rows = [];
  for (const run of takes) {
    const {time} = run;
    const own = curves.map((curve) => curve.run === run ? curve.at : () => null);
    const step = time.length > 2 * most ? Math.ceil(time.length / most) : 1;
    if (step === 1) {
      time.forEach((t, i) => rows.push([t, ...own.map((value) => value(i))]));
      continue;
    }
    for (let from = 0; from < time.length; from += step) {
      const to = Math.min(time.length, from + step);
      const ends = own.map((value) => extremes(value, from, to));
      rows.push([time[from], ...ends.map((pair) => pair[0])],
                [time[to - 1], ...ends.map((pair) => pair[1])]);
    }
  }
  return takes.length > 1 ? rows.sort((a, b) => a[0] - b[0]) : rows;
}

// In the order of their rows.
function extremes(value, from, to) {
  let low = from;
  let high = from;
  for (let i = from; i < to; ++i) {
    if (value(i) < value(low)) low = i;
    if (value(i) > value(high)) high = i;
  }
  return low < high ? [value(low), value(high)] : [value(high), value(low)];
}

function addGraph(title, curves, unit, logarithmic) {
  const box = make('div', at('curves'), undefined, 'curve');
  make('h2', box, title);
  const place = make('div', box, undefined, 'graph');
  const style = getComputedStyle(document.documentElement);
  const options = {};
  curves.forEach((curve, i) => {
    options[`c${i}`] = {
      strokePattern: curve.dashed ? [2, 3] : curve.faint ? [7, 4] : null,
      strokeWidth: curve.faint ? 1.2 : 1.8,
    };
  });
  const graph = new Dygraph(place, rowsOf(curves), {
    labels: ['time', ...curves.map((_, i) => `c${i}`)],
    colors: curves.map((curve) => curve.colour),
    series: options,
    logscale: logarithmic,
    connectSeparatedPoints: takes.length > 1,
    gridLineColor: style.getPropertyValue('--line').trim(),
    axisLineColor: style.getPropertyValue('--line').trim(),
    highlightCircleSize: 0,
    rightGap: 10,
    axes: {
      x: {axisLabelFormatter: (t) => String(Number(t.toPrecision(6)))},
      y: {axisLabelWidth: 62, pixelsPerLabel: 26,
          axisLabelFormatter: (y) => show(y, unit)},
    },
    clickCallback: (event, x) => go(x),
  });
  const cursor = make('div', place, undefined, 'cursor');
  graphs.push({graph, cursor});
}

function spread(curves) {
  let low = Infinity;
  let high = 0;
  for (const {run, at: value} of curves) {
    for (let i = 0; i < run.time.length; ++i) {
      low = Math.min(low, value(i));
      high = Math.max(high, value(i));
    }
  }
  return low > 0 ? high / low : 1;
}

function addCurves() {
  const key = make('ul', at('curves'), undefined, 'key');
  const add = (name, colour) => {
    const item = make('li', key);
    make('span', item, undefined, 'swatch').style.background = colour;
    item.append(name);
  };
  hinged.forEach((body) => add(body.name, body.colour));
  if (takes.length > 1) {
    make('li', key, `line: ${takes[0].name}, dashed: ${takes[1].name}`);
  }
  if (hinged.length > 0) {
    addGraph('Angle of the hinge, deg', hingeCurves('angle_deg'), '');
    addGraph('Rate of the hinge, deg/s', hingeCurves('rate_deg_per_s'), '');
    const locked = data.bodies.some((body) => body.lock);
    addGraph(locked ? 'Reaction (dotted: of the lock)' : 'Reaction',
             [...hingeCurves('reaction_N'),
              ...(locked ? hingeCurves('lock_reaction_N', true) : [])], 'N');
    if (largest('friction_moment_N_m') > 0) {
      addGraph('Friction moment', hingeCurves('friction_moment_N_m'), 'N m');
    }
  }
  if (take.nearest) {
    // The carrier to a body has that body's colour.
    const curves = plainCurves(data.pairs.map(([, b], i) =>
        [pairColumn(i), data.bodies[b].colour]));
    const wide = spread(curves) > 50;
    addGraph('Clearance of ' + (data.pairs.length > 1 ?
        'each two bodies (colour: of the second)' : pairName(0)),
             curves, 'm', wide);
  }
  const energies = {kinetic: '#0072b2', gravity: '#009e73',
                    active_work: '#e69f00', dissipated: '#d55e00'};
  addGraph('Energy', plainCurves(Object.entries(energies).map(
      ([name, colour]) => [`energy.${name}_J`, colour])), 'J');
  const words = make('ul', at('curves').lastChild, undefined, 'key');
  for (const [name, colour] of Object.entries(energies)) {
    const item = make('li', words);
    make('span', item, undefined, 'swatch').style.background = colour;
    item.append(name.replace('_', ' '));
  }
}

function placeCursors() {
  for (const {graph, cursor} of graphs) {
    const area = graph.getArea();
    const x = graph.toDomXCoord(now);
    cursor.hidden = x < area.x || x > area.x + area.w;
    cursor.style.transform = `translate(${x}px, ${area.y}px)`;
    cursor.style.height = `${area.h}px`;
  }
}

// ----------------------------------------------------------------- the tables

const quantities = [
  ['angle', 'angle_deg', '°'], ['rate', 'rate_deg_per_s', '°/s'],
  ['reaction', 'reaction_N', 'N'],
  ['reaction of the lock', 'lock_reaction_N', 'N'],
  ['friction moment', 'friction_moment_N_m', 'N m'],
  ['half-angle of the contact', 'theta0_deg', '°'],
  ['peak pressure', 'peak_pressure_Pa', 'Pa'],
  ['work of friction', 'friction_work_J', 'J'],
].filter(([, column]) => /^(angle|rate|reaction)/.test(column) ||
    largest(column) > 0);
const cells = [];

function addValues() {
  at('readout').hidden = hinged.length === 0;
  const head = make('tr', make('thead', at('values')));
  for (const name of ['body', 'hinge', ...quantities.map((q) => q[0])]) {
    make('th', head, name);
  }
  const body = make('tbody', at('values'));
  for (const item of hinged) {
    const row = make('tr', body);
    const name = make('th', row);
    make('span', name, undefined, 'swatch').style.background = item.colour;
    name.append(item.name);
    const mode = make('td', row);
    cells.push({element: mode, text: () => modes[take.mode(item)]});
    for (const [, column, unit] of quantities) {
      const element = make('td', row);
      element.dataset.column = `${item.column}.${column}`;
      cells.push({element, text: () =>
        show(take.at(element.dataset.column), unit)});
    }
  }
}

function fillValues() {
  for (const {element, text} of cells) {
    const value = text();
    if (element.textContent !== value) element.textContent = value;
  }
}

// Rows of objects, what is in them as "outer.inner"; lists are left out.
function flat(object, prefix = '') {
  return Object.entries(object).flatMap(([key, value]) => {
    if (Array.isArray(value) && typeof value[0] === 'object') return [];
    if (value && typeof value === 'object' && !Array.isArray(value)) {
      return flat(value, `${prefix}${key}.`);
    }
    return [[prefix + key, value]];
  });
}

function cellText(value) {
  if (value === null || value === undefined) return '–';
  if (Array.isArray(value)) {
    // What is rounding beside the others is 0.
    const most = Math.max(...value.map(Math.abs));
    return value.map((x) => cellText(Math.abs(x) < 1e-9 * most ? 0 : x))
        .join(', ') || 'none';
  }
  return typeof value === 'number' ?
      String(Number(value.toPrecision(6))) : String(value);
}

function addTable(parent, title, objects) {
  if (objects.length === 0) return;
  make('h3', parent, title);
  const rows = objects.map((object) => new Map(flat(object)));
  const names = [...new Set(rows.flatMap((row) => [...row.keys()]))];
  const table = make('table', make('div', parent, undefined, 'wide'));
  // As columns objects can be compared, however many values they have.
  const body = make('tbody', table);
  for (const name of names) {
    const line = make('tr', body);
    make('th', line, name.replaceAll('_', ' ').replaceAll('.', ': '));
    for (const row of rows) make('td', line, cellText(row.get(name)));
  }
}

function addSummary() {
  for (const {name, summary} of takes) {
    const box = takes.length > 1 ? make('div', at('summary')) : at('summary');
    if (takes.length > 1) make('h2', box, `Friction: ${name}`);
    const {bodies, clearance, ...rest} = summary;
    addTable(box, 'Run', [rest]);
    addTable(box, 'Bodies', bodies.filter((body) => body.hinge));
    addTable(box, 'Joints', bodies.flatMap((body) =>
        (body.joints || []).map((joint) => ({body: body.name, ...joint}))));
    addTable(box, 'Clearances', clearance);
  }
}

function addEvents() {
  for (const event of events) {
    const button = make('button', make('li', at('events')));
    make('time', button, seconds(event.time_s));
    make('span', button, `${event.body}: ${event.what}`);
    button.onclick = () => go(event.time_s);
    const mark = make('i', at('marks'));
    mark.style.left = `${100 * (event.time_s - take.start) /
        Math.max(1e-300, take.end - take.start)}%`;
    mark.title = `${seconds(event.time_s)}, ${event.body}: ${event.what}`;
    mark.onclick = () => go(event.time_s);
  }
  if (events.length === 0) make('li', at('events'), 'none');
}

function addWords() {
  const laws = new Set(take.summary.bodies.flatMap((body) =>
      (body.joints || []).map((joint) =>
          `${joint.half_angle_law} and ${joint.pressure_law}`)));
  at('about').textContent = [
    `friction ${takes.map((run) => run.name).join(' beside ')}`,
    ...(laws.size > 0 ? [`laws ${[...laws].join('; ')}`] : []),
    ...(data.every > 1 ? [`one of ${data.every} rows of the history`] : []),
    data.program].join(' · ');
  for (const text of data.warnings) make('li', at('warnings'), text);
  if (data.warnings.length === 0) make('li', at('warnings'), 'none');
  at('case').hidden = data.case === '';
  at('case').querySelector('pre').textContent = data.case;
}

// ------------------------------------------------------------------- the time

let now = take.start;
let playing = false;
let picture;
let labels;
let lastFill = 0;
let ownTime = 0;  // ms of this script in the last frame, without drawing

// The last event not after now, in words.
function sayEvent() {
  let text = '';
  let current = -1;
  events.forEach((event, i) => {
    if (event.time_s <= now + 1e-9) current = i;
  });
  if (current >= 0) {
    const {time_s: time, body, what} = events[current];
    text = `${seconds(time)}  ${body}: ${what}`;
  }
  if (at('now').textContent !== text) {
    at('now').textContent = text;
    const items = at('events').querySelectorAll('button');
    items.forEach((item, i) => item.classList.toggle('current', i === current));
  }
}

function update(clock) {
  const begin = performance.now();
  for (const run of takes) run.go(now);
  at('time').value = now;
  at('clock').textContent = seconds(now);
  at('time').setAttribute('aria-valuetext', seconds(now));
  placeCursors();
  if (picture) {
    picture.set(now);
    labels.place();
  }
  // Numbers that change sixty times a second nobody reads.
  if (!playing || clock - lastFill > 120) {
    lastFill = clock;
    fillValues();
    sayEvent();
  }
  ownTime = performance.now() - begin;
  if (picture) picture.draw();
}

// Once a frame, however often it is asked for.
let asked = false;
function refresh() {
  if (asked) return;
  asked = true;
  requestAnimationFrame((clock) => {
    asked = false;
    update(clock);
  });
}

function go(time) {
  now = Math.min(take.end, Math.max(take.start, time));
  refresh();
}

function play(on) {
  playing = on;
  at('play').textContent = on ? '\u23F8\uFE0E' : '\u25B6\uFE0E';
  at('play').setAttribute('aria-label', on ? 'Pause' : 'Play');
  if (!on) return refresh();
  if (now >= take.end) now = take.start;
  let before;
  // Who wants no motion gets two pictures a second.
  const least = still ? 500 : 0;
  const step = (clock) => {
    if (!playing) return;
    if (before === undefined) before = clock;
    if (clock - before >= least) {
      now = Math.min(take.end,
                     now + (clock - before) / 1000 * Number(at('speed').value));
      before = clock;
      update(clock);
    }
    if (now >= take.end) return play(false);
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

function jump(direction) {
  const times = [take.start, ...events.map((event) => event.time_s), take.end];
  const next = direction > 0 ? times.find((time) => time > now + 1e-9) :
      times.reverse().find((time) => time < now - 1e-9);
  if (next !== undefined) go(next);
}

function row(direction) {
  take.go(now);
  let i = take.row;
  if (direction > 0) while (take.time[i] <= now) ++i;
  else while (i > 0 && take.time[i] >= now) --i;
  if (i < take.time.length) go(take.time[i]);
}

function follow(body) {
  at('follow').value = body;
  picture.follow = body;
  picture.controls.target.add(picture.root.localToWorld(
      picture.bodies[body].position.clone())).sub(picture.target);
  refresh();
}

function onKey(event) {
  const {key, target} = event;
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const typing = ['SELECT', 'INPUT'].includes(target.tagName);
  const inPicture = target === at('view');
  const turns = {ArrowLeft: [-0.08, 0], ArrowRight: [0.08, 0],
                 ArrowUp: [0, -0.08], ArrowDown: [0, 0.08]};
  if (inPicture && picture && turns[key]) {
    picture.turn(...turns[key]);
  } else if (picture && (key === '+' || key === '=')) {
    picture.zoom(1 / 1.1);
  } else if (picture && key === '-') {
    picture.zoom(1.1);
  } else if (picture && key === '0') {
    picture.fit();
  } else if (picture && key === 'f' && target.tagName !== 'SELECT') {
    return follow((picture.follow + 1) % data.bodies.length);
  } else if (key === ' ' && !['BUTTON', 'SUMMARY'].includes(target.tagName) &&
             target.type !== 'checkbox') {
    play(!playing);
  } else if (key === '[') {
    jump(-1);
  } else if (key === ']') {
    jump(1);
  } else if (key === ',') {
    row(-1);
  } else if (key === '.') {
    row(1);
  } else if (key === 'Home' && !typing) {
    go(take.start);
  } else if (key === 'End' && !typing) {
    go(take.end);
  } else {
    return;
  }
  event.preventDefault();
  refresh();
}

function addControls() {
  const slider = at('time');
  slider.min = take.start;
  slider.max = take.end;
  slider.oninput = () => go(Number(slider.value));
  at('play').onclick = () => play(!playing);
  at('previous').onclick = () => jump(-1);
  at('next').onclick = () => jump(1);
  const lasts = take.end - take.start;
  const speeds = [];
  for (let exponent = -3; exponent <= 3; ++exponent) {
    for (const digit of [1, 2, 5]) speeds.push(digit * 10 ** exponent);
  }
  // From 3 to 40 s are watched as they are.
  const best = lasts >= 3 && lasts <= 40 ? 1 :
      speeds.reduce((a, b) => Math.abs(Math.log(b * 10 / lasts)) <
          Math.abs(Math.log(a * 10 / lasts)) ? b : a);
  for (const speed of speeds) {
    const option =
        make('option', at('speed'), `${Number(speed.toPrecision(2))}×`);
    option.value = speed;
    option.selected = speed === best;
  }
  data.bodies.forEach((body, i) => {
    make('option', at('follow'), body.name).value = i;
  });
  at('follow').onchange = () => follow(Number(at('follow').value));
  at('fit').onclick = () => {
    picture.fit();
    refresh();
  };
  for (const id of ['show_forces', 'show_distance', 'show_names']) {
    at(id).onchange = refresh;
  }
  document.addEventListener('keydown', onKey);
}

async function addPicture() {
  try {
    const made = new Picture(at('view'));
    await made.load();
    picture = made;
    picture.controls.addEventListener('change', refresh);
    labels = new Labels(picture);
    addLegend(picture);
    new ResizeObserver(() => {
      picture.resize();
      refresh();
    }).observe(at('scene'));
  } catch (error) {
    console.info(`no picture: ${error.message}`);
    at('view').hidden = true;
    at('no_webgl').hidden = false;
    document.querySelectorAll('.needs_scene').forEach((element) => {
      element.hidden = true;
    });
  }
}

addWords();
addEvents();
addControls();
addValues();
addSummary();
addCurves();
const ready = addPicture().then(() => update(performance.now()));

// For whoever wants to ask the page from its console.
window.replay = {
  ready, go, play,
  get time() { return now; },
  get ownTime() { return ownTime; },
  update: () => update(performance.now()),
  value: (column) => take.at(column),
  // From the carrier's centre of mass, inertial axes.
  pose: (body) => ({position: picture.bodies[body].position.toArray(),
                    rotation: picture.bodies[body].quaternion.toArray()}),
};
})();

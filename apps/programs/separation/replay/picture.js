// The bodies in motion, with what is drawn and written beside them.

const colours = {reaction: '#e0345c', lock: '#0e9aa7', moment: '#9a5fe0',
                 distance: '#e0218a', applied: '#e08a00', between: '#5b9f3c',
                 drive: '#a0703c'};
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

// The length of the longest arrow of a kind, as a part of the scene's size.
const arrowLength = 0.42;
const onTop = (colour) => new THREE.MeshBasicMaterial(
    {color: new THREE.Color(colour).convertSRGBToLinear(), depthTest: false,
     transparent: true});
// The parts of an arrow have length 1, from the origin along y and to it.
const shaft = new THREE.CylinderBufferGeometry(1, 1, 1, 12);
shaft.translate(0, 0.5, 0);
const head = new THREE.ConeBufferGeometry(1, 1, 16);
head.translate(0, -0.5, 0);

// The corners of the box about a body with its marks, in its axes.
function cornersOf(body) {
  const box = new THREE.Box3();
  body.traverse((part) => {
    if (!part.isMesh) return;
    part.geometry.computeBoundingBox();
    part.updateMatrix();
    const own = part.geometry.boundingBox.clone();
    box.union(part === body ? own : own.applyMatrix4(part.matrix));
  });
  const {min, max} = box;
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => new THREE.Vector3(
      k & 1 ? min.x : max.x, k & 2 ? min.y : max.y, k & 4 ? min.z : max.z));
}

// A cap of a ball about y, or a strip of a pin along z, of a half-angle in
// whole degrees.
function patchShape(degrees, pin, radius) {
  const t = degrees * Math.PI / 180;
  if (!pin) {
    return new THREE.SphereBufferGeometry(radius, 32, 12, 0, 2 * Math.PI, 0, t);
  }
  const shape = new THREE.CylinderBufferGeometry(
      radius, radius, 2 * radius, 24, 1, true, -t, 2 * t);
  shape.rotateX(Math.PI / 2);  // the axis to z, its middle to -y
  shape.rotateZ(Math.PI);
  return shape;
}

// Along a vector, with its heads one behind the other.
function layArrow({shaft, heads}, from, vector, length, headLength) {
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

class Picture {
  constructor(canvas) {
    this.renderer = new THREE.WebGLRenderer(
        // A picture of the page that comes a frame later has the bodies too.
        {canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
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
    this.stage = gltf.scene;
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
    for (const i of data.nodes) this.bodies.push(await node(i));
    this.corners = this.bodies.map(cornersOf);
    this.addMarks();
    this.resize();
    this.fit();
  }

  // Marks are drawn beside the bodies, in inertial axes about the carrier, and
  // over all that is behind them.
  add(geometry, material, order) {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.renderOrder = order;
    mesh.frustumCulled = false;
    mesh.visible = false;
    this.root.add(mesh);
    return mesh;
  }

  addLine(colour, order) {
    return this.add(shaft, onTop(colour), order);
  }

  addArrow(colour, heads) {
    const material = onTop(colour);
    return {shaft: this.add(shaft, material, 3), heads: Array.from(
        {length: heads}, () => this.add(head, material, 3))};
  }

  addMarks() {
    this.hinges = hinged.map((body) => ({
      body,
      number: data.bodies.indexOf(body),
      reaction: this.addArrow(colours.reaction, 1),
      lock: body.lock && this.addArrow(colours.lock, 1),
      moment: this.addArrow(colours.moment, 2),
      patch: this.add(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial(
          {side: THREE.DoubleSide, depthTest: false, transparent: true,
           opacity: 0.92}), 2),
    }));
    this.patches = new Map();
    this.most = {reaction: largest('reaction_N'),
                 lock: largest('lock_reaction_N'),
                 moment: largest('friction_moment_N_m'),
                 pressure: largest('peak_pressure_Pa')};
    this.forces = new ForceMarks(this);
    this.engines = new Engines(this);
    this.line = this.addLine(colours.distance, 4);
  }

  patch(degrees, pin) {
    const key = pin ? -degrees - 1 : degrees;
    if (!this.patches.has(key)) {
      this.patches.set(key, patchShape(degrees, pin, 0.035 * this.size));
    }
    return this.patches.get(key);
  }

  set(time) {
    for (const {object, property, values} of this.tracks) {
      property.fromArray(values.evaluate(time));
      object.visible = object.scale.x > 0;
    }
    this.setStage();
    for (const hinge of this.hinges) this.setHinge(hinge);
    this.forces.set();
    this.engines.set();
    this.setLine();
    this.setTarget();
    this.setDistance();
  }

  // A point of a body's axes in those of the root.
  place(body, point) {
    const {quaternion, position} = this.bodies[body];
    return new THREE.Vector3(...point).applyQuaternion(quaternion)
        .add(position);
  }

  vector(body, quantity, unit, into) {
    return into.set(...['x', 'y', 'z'].map(
        (axis) => take.at(`${body.column}.${quantity}_${axis}_${unit}`)));
  }

  setHinge(hinge) {
    const {body, number, patch} = hinge;
    const on = at('show_forces').checked && take.held(body);
    hinge.centre = this.place(number, body.hinge.point);
    if (body.lock) {
      this.setArrow(
          hinge.lock, on && take.mode(body) === locked,
          this.place(number, body.lock.point),
          this.vector(body, 'lock_reaction', 'N', new THREE.Vector3()),
          this.most.lock);
    }
    const force = this.vector(body, 'reaction', 'N', new THREE.Vector3());
    const moment =
        this.vector(body, 'friction_moment', 'N_m', new THREE.Vector3());
    this.setArrow(hinge.reaction, on, hinge.centre, force, this.most.reaction);
    this.setArrow(hinge.moment, on && moment.length() > 0, hinge.centre, moment,
                  this.most.moment);
    hinge.force = force;
    hinge.turning = moment;
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
          .applyQuaternion(this.bodies[body.hinge.on].quaternion);
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
    const length = arrowLength * this.size * vector.length() / most;
    layArrow({shaft, heads}, from, vector, length, Math.min(
        0.035 * this.size, 0.6 * length / heads.length));
  }

  // Between the two bodies that are nearest, by the points of the last row.
  setLine() {
    this.gap = undefined;
    const points = take.nearest;
    const i = 7 * take.row;
    this.line.visible =
        at('show_distance').checked && points !== undefined && points[i] >= 0;
    if (!this.line.visible) return;
    const [from, to] = data.pairs[points[i]].map((body, j) => this.place(
        body, points.subarray(i + 1 + 3 * j, i + 4 + 3 * j)));
    this.stretch(this.line, from, to, 0.0018 * this.size);
    this.gap = {pair: points[i], middle: from.lerp(to, 0.5)};
  }

  // A line from one place to another.
  stretch(line, from, to, width) {
    const span = to.clone().sub(from);
    line.position.copy(from);
    line.quaternion.setFromUnitVectors(
        new THREE.Vector3(0, 1, 0), span.clone().normalize());
    line.scale.set(width, Math.max(1e-9, span.length()), width);
  }

  placeOf(body) {
    return this.root.localToWorld(this.bodies[body].position.clone());
  }

  // From body axes to those of the stage.
  turnOf(body) {
    return this.root.quaternion.clone().multiply(this.bodies[body].quaternion);
  }

  // The followed body keeps the directions that it has now in the picture, or
  // directions are inertial again. The stage turns: the camera's upwards is y.
  setTurning(on) {
    this.kept = on ? this.stage.quaternion.clone()
        .multiply(this.turnOf(this.follow)) : undefined;
    this.setStage();
  }

  setStage() {
    if (this.kept) {
      this.stage.quaternion.copy(this.kept)
          .multiply(this.turnOf(this.follow).conjugate());
    } else {
      this.stage.quaternion.set(0, 0, 0, 1);
    }
    this.root.updateWorldMatrix(true, false);
  }

  // Into the middle, seen as before.
  setFollow(body) {
    this.follow = body;
    this.setTurning(this.kept !== undefined);
    this.target.copy(this.controls.target);
    this.setTarget();
  }

  // The camera moves with the body.
  setTarget() {
    const way = this.placeOf(this.follow).sub(this.target);
    this.target.add(way);
    this.camera.position.add(way);
    this.controls.target.add(way);
  }

  resize() {
    const {clientWidth, clientHeight} = at('scene');
    if (clientWidth === 0 || clientHeight === 0) return;
    this.width = clientWidth;
    this.height = clientHeight;
    this.renderer.setSize(clientWidth, clientHeight, false);
    // The bodies are to the left of the contact in its corner.
    this.free = clientWidth - (this.contact?.shown ? contactSize + 16 : 0);
    this.camera.setViewOffset(this.free, clientHeight, 0, 0, clientWidth,
                              clientHeight);
  }

  // The distance from its target at which the camera sees all bodies in the
  // inner 0.9 of the picture.
  neededDistance() {
    const [right, up, back] =
        [0, 1, 2].map(() => new THREE.Vector3());
    this.camera.matrixWorld.extractBasis(right, up, back);
    const high = 0.9 * Math.tan(this.camera.fov * Math.PI / 360);
    const wide = high * this.camera.aspect;
    let needed = 0;
    this.corners.forEach((corners, body) => {
      for (const corner of corners) {
        const p = this.root.localToWorld(this.place(body, corner.toArray()))
            .sub(this.controls.target);
        needed = Math.max(needed, p.dot(back) + Math.max(
            Math.abs(p.dot(right)) / wide, Math.abs(p.dot(up)) / high));
      }
    });
    return needed;
  }

  // The camera is as far as was chosen, or further if bodies would be out of
  // view. Going nearer by hand ends that.
  setDistance() {
    const way = this.camera.position.clone().sub(this.controls.target);
    const distance = way.length();
    if (Math.abs(distance - this.distance) > 1e-6 * distance) {
      if (distance < this.distance) at('all').checked = false;
      this.chosen = distance;
    }
    this.distance = at('all').checked ?
        Math.max(this.chosen, this.neededDistance()) : this.chosen;
    this.camera.position.copy(this.controls.target)
        .addScaledVector(way, this.distance / distance);
    // The depths that are drawn go with it.
    this.camera.near = Math.max(0.01 * this.size, 1e-4 * this.distance);
    this.camera.far = Math.max(400 * this.size, 4 * this.distance);
    this.camera.updateProjectionMatrix();
  }

  // All bodies, as they are now, from where the camera is.
  fit() {
    this.root.updateWorldMatrix(true, true);
    const box = new THREE.Box3();
    this.corners.forEach((corners, body) => corners.forEach((corner) =>
        box.expandByPoint(
            this.root.localToWorld(this.place(body, corner.toArray())))));
    const from = this.camera.position.length() > 0 ?
        this.camera.position.clone().sub(this.controls.target).normalize() :
        new THREE.Vector3(0.4, 0.35, 1).normalize();
    box.getCenter(this.controls.target);
    this.camera.position.copy(this.controls.target).add(from);
    this.camera.lookAt(this.controls.target);
    this.camera.updateMatrixWorld();
    this.distance = this.chosen = this.neededDistance();
    this.camera.position.copy(this.controls.target)
        .addScaledVector(from, this.distance);
    this.controls.update();
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

  // Where a point of the root's axes is in the picture, px.
  project(point) {
    const p = this.root.localToWorld(point.clone()).project(this.camera);
    return {x: (p.x + 1) / 2 * this.width, y: (1 - p.y) / 2 * this.height,
            visible: p.z < 1};
  }

  draw() {
    this.controls.update();
    this.renderer.render(this.scene, this.camera);
    if (this.contact) this.contact.draw();
  }
}

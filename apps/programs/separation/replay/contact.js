// The contact of one hinge in a corner of the picture, much larger than it is:
// the ball or pin, which turns with its body, the patch coloured by its
// pressure, reaction and friction. Seen as the bodies are.

const contactSize = 190;  // px

class ContactView {
  constructor(picture) {
    this.picture = picture;
    this.hinges = picture.hinges.filter(({body}) => body.hinge.contact);
    at('contact').hidden = this.hinges.length === 0;
    this.hinges.forEach(({body}, i) => {
      make('option', at('hinge'), body.name).value = i;
    });
    at('hinge').onchange = refresh;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 1, 20);
    this.scene.add(this.camera);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x667788, 1));
    this.root = new THREE.Group();
    this.scene.add(this.root);
    this.shapes = new Map();
    this.patch = this.add(new THREE.Mesh(
        new THREE.BufferGeometry(), new THREE.MeshBasicMaterial(
            {side: THREE.DoubleSide, vertexColors: THREE.VertexColors,
             depthTest: false, transparent: true})), 1);
    this.inner = this.hinges.map((hinge) => this.addInner(hinge));
    this.arrows = {reaction: this.addArrow(colours.reaction, 1),
                   moment: this.addArrow(colours.moment, 2)};
  }

  get shown() {
    return this.hinges.length > 0 && at('show_contact').checked &&
        this.picture.width > 2.5 * contactSize;
  }

  add(mesh, order) {
    mesh.renderOrder = order;
    mesh.frustumCulled = false;
    this.root.add(mesh);
    return mesh;
  }

  addArrow(colour, heads) {
    const material = onTop(colour);
    return {shaft: this.add(new THREE.Mesh(shaft, material), 2),
            heads: Array.from({length: heads},
                              () => this.add(new THREE.Mesh(head, material), 2))};
  }

  // A ball or pin of radius 1 with lines by which its turning is seen.
  addInner({body}) {
    const pin = body.hinge.axis !== undefined;
    const shape = pin ? new THREE.CylinderBufferGeometry(1, 1, 2, 40) :
        new THREE.SphereBufferGeometry(1, 40, 24);
    const lines = new THREE.LineSegments(
        new THREE.WireframeGeometry(pin ?
            new THREE.CylinderBufferGeometry(1, 1, 2, 8, 1, true) :
            new THREE.OctahedronBufferGeometry(1, 2)),
        new THREE.LineBasicMaterial(
            {color: 0x333333, transparent: true, opacity: 0.6}));
    lines.scale.setScalar(1.06);  // over the surface between their ends too
    const group = new THREE.Group();
    group.add(new THREE.Mesh(shape, new THREE.MeshLambertMaterial(
        {color: new THREE.Color('#b9c4d0').convertSRGBToLinear()})), lines);
    if (pin) {
      group.children.forEach((part) => part.quaternion.setFromUnitVectors(
          new THREE.Vector3(0, 1, 0), new THREE.Vector3(...body.hinge.axis)));
    }
    return this.add(group, 0);
  }

  // The patch of a half-angle in whole degrees, with the part of the peak
  // pressure at each corner.
  shape(degrees, {hinge}) {
    const pin = hinge.axis !== undefined;
    const key = `${degrees} ${pin} ${hinge.contact.half_angles_deg.length}`;
    if (!this.shapes.has(key)) {
      const geometry = patchShape(degrees, pin, 1.01);
      const {count, itemSize} = geometry.getAttribute('position');
      geometry.setAttribute('color', new THREE.BufferAttribute(
          new Float32Array(count * itemSize), 3));
      this.shapes.set(key, geometry);
    }
    return this.shapes.get(key);
  }

  // By the law of the joint, from the nearest half-angle of its table.
  paint(geometry, {hinge}, degrees, part) {
    const {half_angles_deg: tabled, shares} = hinge.contact;
    let k = 0;
    tabled.forEach((angle, i) => {
      if (Math.abs(angle - degrees) < Math.abs(tabled[k] - degrees)) k = i;
    });
    const place = geometry.getAttribute('position');
    const colour = geometry.getAttribute('color');
    const of = new THREE.Color();
    for (let i = 0; i < place.count; ++i) {
      const t = Math.acos(Math.min(1, place.getY(i) / 1.01)) * 180 / Math.PI;
      const at = Math.min(0.9999, t / degrees) * (shares[k].length - 1);
      const j = Math.floor(at);
      const share = shares[k][j] + (at - j) * (shares[k][j + 1] - shares[k][j]);
      scaleColour(part * share, of).convertSRGBToLinear();
      colour.setXYZ(i, of.r, of.g, of.b);
    }
    colour.needsUpdate = true;
  }

  place() {
    const {picture} = this;
    at('contact').hidden = !this.shown;
    if (!this.shown) return;
    const hinge = this.hinges[at('hinge').value];
    const {body, number} = hinge;
    const pressed = hinge.patch.visible;
    this.inner.forEach((group, i) => {
      group.visible = this.hinges[i] === hinge;
    });
    const inner = body.hinge.inner === 'carrier' ? 0 : number;
    this.inner[this.hinges.indexOf(hinge)].quaternion.copy(
        picture.bodies[inner].quaternion);
    this.patch.visible = pressed;
    const value = (name) => take.at(`${body.column}.${name}`);
    const degrees = Math.max(1, Math.round(value('theta0_deg')));
    if (pressed) {
      this.patch.geometry = this.shape(degrees, body);
      this.patch.quaternion.copy(hinge.patch.quaternion);
      this.paint(this.patch.geometry, body, degrees,
                 value('peak_pressure_Pa') / picture.most.pressure);
    }
    this.setArrow(this.arrows.reaction, pressed, hinge.force,
                  picture.most.reaction);
    this.setArrow(this.arrows.moment, pressed, hinge.turning,
                  picture.most.moment);
    const text = pressed ? `θ₀ ${value('theta0_deg').toFixed(1)}°  peak ` +
        `${show(value('peak_pressure_Pa'), 'Pa')}\nfriction ` +
        show(hinge.turning.length(), 'N m') : 'no contact';
    if (at('contact_text').textContent !== text) {
      at('contact_text').textContent = text;
    }
  }

  // Up to 1.7 radii long.
  setArrow(arrow, on, vector, most) {
    const length = most > 0 ? 1.7 * vector.length() / most : 0;
    for (const part of [arrow.shaft, ...arrow.heads]) {
      part.visible = on && length > 0.02;
    }
    if (!arrow.shaft.visible) return;
    layArrow(arrow, new THREE.Vector3(), vector, length,
             Math.min(0.25, 0.6 * length / arrow.heads.length));
  }

  // Over what the renderer has drawn.
  draw() {
    if (!this.shown) return;
    const {renderer, camera, root, width, height} = this.picture;
    root.getWorldQuaternion(this.root.quaternion);
    camera.getWorldQuaternion(this.camera.quaternion);
    this.camera.position.set(0, 0, 7.5).applyQuaternion(this.camera.quaternion);
    const box = [width - contactSize - 8, height - contactSize - 8,
                 contactSize, contactSize];
    renderer.setScissorTest(true);
    renderer.setScissor(...box);
    renderer.setViewport(...box);
    renderer.autoClear = false;
    renderer.clear();
    renderer.render(this.scene, this.camera);
    renderer.autoClear = true;
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
  }
}

// Names, numbers and scales over the picture and below it.

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
      // Not over the edge, and below those that are in its place.
      const width = label.textContent.length * 7 + 14;
      const edge = Math.min(width, picture.width) / 2;
      const here = {x: x < 0 || x > picture.width ? x :
          Math.min(Math.max(x, edge), picture.width - edge), y: y + down, width};
      const covers = (other) => Math.abs(here.y - other.y) < 16 &&
          2 * Math.abs(here.x - other.x) < width + other.width;
      for (let tries = 0; tries < 6 && placed.some(covers); ++tries) {
        here.y += 16;
      }
      placed.push({...here, text: label.textContent,
                   colour: label.style.borderColor});
      label.style.transform = `translate(${here.x.toFixed(1)}px, ` +
          `${here.y.toFixed(1)}px) translate(-50%, -50%)`;
    };
    this.placed = placed;
    const {gap} = picture;
    if (gap) {
      const distance = show(take.at(pairColumn(gap.pair)), 'm');
      const text = `${pairName(gap.pair)}: ${distance}`;
      if (this.distance.textContent !== text) this.distance.textContent = text;
    }
    move(this.distance, gap && gap.middle, gap !== undefined, -16);
    const named = at('show_names').checked;
    this.names.forEach((label, i) =>
        move(label, picture.bodies[i].position, named, 16));
  }
}

// The inertial axes, gravity, and a length at the place that is looked at.
class Compass {
  constructor(picture) {
    this.picture = picture;
    this.axes = [['x', '#d2453f', [1, 0, 0]], ['y', '#3f9b3f', [0, 1, 0]],
                 ['z', '#4178d4', [0, 0, 1]]];
    if (Math.hypot(...data.gravity) > 0) {
      this.axes.push(['g', '#8a8f98', data.gravity]);
    }
    const parts = (tag) => this.axes.map(([, colour]) => {
      const part = at('compass').appendChild(
          document.createElementNS(at('compass').namespaceURI, tag));
      part.setAttribute(tag === 'line' ? 'stroke' : 'fill', colour);
      return part;
    });
    this.lines = parts('line');
    this.letters = parts('text');
    this.letters.forEach((letter, i) => {
      letter.textContent = this.axes[i][0];
    });
  }

  // Ends of the axes, px from their beginning to the right and down.
  ends() {
    const {root, camera} = this.picture;
    const turn = camera.quaternion.clone().conjugate()
        .multiply(root.getWorldQuaternion(new THREE.Quaternion()));
    return this.axes.map(([, , way]) => {
      const v = new THREE.Vector3(...way).normalize().applyQuaternion(turn);
      return [26 * v.x, -26 * v.y];
    });
  }

  // A round length that takes 40 to 100 px.
  scale() {
    const {camera, distance, height} = this.picture;
    const pixels =
        height / (2 * distance * Math.tan(camera.fov * Math.PI / 360));
    const power = 10 ** Math.floor(Math.log10(100 / pixels));
    const length =
        power * [5, 2, 1].find((digit) => digit * power * pixels <= 100);
    return {length, width: length * pixels, text: show(length, 'm')};
  }

  place() {
    this.ends().forEach(([x, y], i) => {
      this.lines[i].setAttribute('x2', x);
      this.lines[i].setAttribute('y2', y);
      this.letters[i].setAttribute('x', 1.35 * x);
      this.letters[i].setAttribute('y', 1.35 * y + 4);
    });
    const {width, text} = this.scale();
    at('scale').style.width = `${width}px`;
    if (at('scale').textContent !== text) at('scale').textContent = text;
  }
}

function addLegend({most, forces}) {
  const line = (text) => make('p', at('legend'), text);
  const entry = (mark, colour, text) => {
    const p = line('');
    make('b', p, mark).style.color = colour;
    p.append(text);
  };
  if (forces.most.applied > 0) {
    entry('→', colours.applied,
          `forces from outside, up to ${show(forces.most.applied, 'N')}`);
  }
  if (forces.most.between > 0) {
    entry('→', colours.between,
          `forces between bodies, up to ${show(forces.most.between, 'N')}`);
  }
  if (forces.most.drive > 0) {
    entry('↠', colours.drive,
          `moments, up to ${show(forces.most.drive, 'N m')}`);
  }
  if (hinged.length === 0) return;
  entry('→', colours.reaction, `reaction, up to ${show(most.reaction, 'N')}`);
  if (most.lock > 0) {
    entry('→', colours.lock,
          `reaction of locks, up to ${show(most.lock, 'N')}`);
  }
  if (!(most.moment > 0)) return;
  entry('↠', colours.moment, `friction, up to ${show(most.moment, 'N m')}`);
  const p = line('pressure 0');
  make('i', p);
  p.append(show(most.pressure, 'Pa'));
}

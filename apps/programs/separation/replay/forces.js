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

// The time, who moves it, and what follows it.

let now = take.start;
let playing = false;
let picture;
let labels;
let compass;
let lastFill = 0;
let ownTime = 0;  // ms of this script in the last frame, without drawing

// The last events not after now, in words.
function sayEvent() {
  const last = instants.filter(({time}) => time <= now + 1e-9).pop();
  const text = last ? instantText(last) : '';
  if (at('now').textContent !== text) {
    at('now').textContent = text;
    const items = at('events').querySelectorAll('button');
    items.forEach((item, i) => item.classList.toggle(
        'current', last !== undefined && last.events.includes(events[i])));
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
    compass.place();
    picture.contact.place();
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

// Seconds of the motion in a second. Events are watched at a sixth of the speed,
// from half a second before them to half a second behind.
function paceAt(moment) {
  const speed = Number(at('speed').value);
  if (!at('slow').checked) return speed;
  const near = instants.reduce((nearest, {time}) =>
      Math.min(nearest, Math.abs(time - moment)), Infinity);
  return Math.min(speed, speed / 6 + 5 / 3 * near);
}

function play(on) {
  if (on && playing) return;
  playing = on;
  at('play').textContent = on ? '' : '\u25B6\uFE0E';
  at('play').setAttribute('aria-label', on ? 'Pause' : 'Play');
  if (!on) return refresh();
  if (now >= take.end) now = take.start;
  let before;
  // Who wants no motion gets two pictures a second.
  const least = still ? 500 : 0;
  // A busy machine shows all of the motion, and later.
  const most = still ? 1000 : 100;
  const step = (clock) => {
    if (!playing) return;
    if (before === undefined) before = clock;
    if (clock - before >= least) {
      now = Math.min(
          take.end, now + Math.min(clock - before, most) / 1000 * paceAt(now));
      before = clock;
      update(clock);
    }
    if (now >= take.end) return play(false);
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

function jump(direction) {
  const times = [take.start, ...instants.map(({time}) => time), take.end];
  const next = direction > 0 ? times.find((time) => time > now + 1e-9) :
      times.reverse().find((time) => time < now - 1e-9);
  if (next !== undefined) go(next);
}

function row(direction) {
  play(false);
  take.go(now);
  let i = take.row;
  if (direction > 0) while (take.time[i] <= now) ++i;
  else while (i > 0 && take.time[i] >= now) --i;
  if (i < take.time.length) go(take.time[i]);
}

function follow(body) {
  at('follow').value = body;
  const hinge =
      picture.contact.hinges.findIndex(({number}) => number === body);
  if (hinge >= 0) at('hinge').value = hinge;
  picture.setFollow(body);
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
  } else if (picture && key === 'a' && target.tagName !== 'SELECT') {
    at('all').click();
  } else if (picture && key === 'p' && target.tagName !== 'SELECT') {
    savePicture();
  } else if (picture && key === 't' && target.tagName !== 'SELECT') {
    at('turning').click();
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
  at('turning').onchange = () => {
    picture.setTurning(at('turning').checked);
    refresh();
  };
  at('fit').onclick = () => {
    picture.fit();
    refresh();
  };
  at('all').onchange = () => {
    picture.chosen = picture.distance;
    refresh();
  };
  at('save_picture').onclick = savePicture;
  at('save_film').onclick = saveFilm;
  for (const id of ['show_forces', 'show_distance', 'show_names']) {
    at(id).onchange = refresh;
  }
  at('show_contact').onchange = () => {
    picture.resize();
    refresh();
  };
  document.addEventListener('keydown', onKey);
}

async function addPicture() {
  try {
    const made = new Picture(at('view'));
    await made.load();
    picture = made;
    picture.controls.addEventListener('change', refresh);
    labels = new Labels(picture);
    compass = new Compass(picture);
    picture.contact = new ContactView(picture);
    picture.resize();
    picture.fit();
    addLegend(picture);
    new ResizeObserver(() => {
      picture.resize();
      refresh();
    }).observe(at('scene'));
  } catch (error) {
    console.info(`no picture: ${error.message}`);
    at('view').hidden = true;
    at('corner').hidden = true;
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
const ready = addPicture().then(() => {
  update(performance.now());
  if (!still) play(true);
});

// The page, asked from its console.
window.replay = {
  ready, play, paceAt, snapshot,
  go: (time) => {
    play(false);
    go(time);
  },
  get time() { return now; },
  get ownTime() { return ownTime; },
  update: () => update(performance.now()),
  value: (column) => take.at(column),
  // From the carrier's centre of mass, inertial axes.
  pose: (body) => ({position: picture.bodies[body].position.toArray(),
                    rotation: picture.bodies[body].quaternion.toArray()}),
  // Of a point in a body's axes (else its centre of mass) in the picture, px
  // from the middle of the view.
  offset: (body, point = [0, 0, 0]) => {
    const {position, quaternion} = picture.bodies[body];
    const {x, y} = picture.project(new THREE.Vector3(...point)
        .applyQuaternion(quaternion).add(position));
    return [x - picture.free / 2, y - picture.height / 2];
  },
  // The 'arrow', 'opposite' or 'moment' of a force of the case, as below.
  force: (number, kind) => tipsOf(picture.forces.marks[number][kind]),
  // Length of the plume of an engine, m.
  plume: (number) => picture.engines.all[number].length,
  // Length of its arrow when it is largest, m.
  mostForce: (number) => {
    const {kind} = picture.forces.marks[number];
    return arrowLength * picture.size * mostOf(number).force /
        picture.forces.most[kind];
  },
  // A body's 'reaction', 'lock' or 'moment': where the arrow begins and its
  // tip, in the same axes as poses; nothing where none is drawn.
  arrow: (body, kind) => tipsOf(picture.hinges.find(
      (hinge) => hinge.body === data.bodies[body])[kind]),
};

function tipsOf(arrow) {
  if (!arrow || !arrow.shaft.visible) return undefined;
  return [arrow.shaft, arrow.heads[0]].map(({position}) => position.toArray());
}

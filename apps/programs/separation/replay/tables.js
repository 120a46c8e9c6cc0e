// Numbers of now, events, warnings, summary.

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

// A row with the name of a body.
function bodyRow(table, item) {
  const row = make('tr', table);
  const name = make('th', row);
  make('span', name, undefined, 'swatch').style.background = item.colour;
  name.append(item.name);
  return row;
}

function addForceValues() {
  at('force_values').hidden = !take.forces;
  if (!take.forces) return;
  const head = make('tr', make('thead', at('force_values')));
  for (const name of ['body', 'force of the case', 'force', 'moment']) {
    make('th', head, name);
  }
  const table = make('tbody', at('force_values'));
  data.forces.forEach(({name, body}, i) => {
    const row = bodyRow(table, data.bodies[body]);
    make('td', row, name);
    for (const [what, unit] of [['force', 'N'], ['moment', 'N m']]) {
      cells.push({element: make('td', row), text: () => {
        const acts = take.force(i);
        const size = acts ? Math.hypot(...acts[what]) : 0;
        return size > 0 ? show(size, unit) : '–';
      }});
    }
  });
}

function addValues() {
  at('readout').hidden = hinged.length === 0 && !take.forces;
  addForceValues();
  if (hinged.length === 0) return;
  const head = make('tr', make('thead', at('values')));
  for (const name of ['body', 'hinge', ...quantities.map((q) => q[0])]) {
    make('th', head, name);
  }
  const body = make('tbody', at('values'));
  for (const item of hinged) {
    const row = bodyRow(body, item);
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
    if (takes.length > 1) make('h2', box, name);
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
    make('span', button, eventText(event));
    button.onclick = () => go(event.time_s);
  }
  for (const instant of instants) {
    const mark = make('i', at('marks'));
    mark.style.left = `${100 * (instant.time - take.start) /
        Math.max(1e-300, take.end - take.start)}%`;
    mark.title = instantText(instant);
    mark.onclick = () => go(instant.time);
  }
  if (events.length === 0) make('li', at('events'), 'none');
}

function addWords() {
  const laws = new Set(take.summary.bodies.flatMap((body) =>
      (body.joints || []).map((joint) =>
          `${joint.half_angle_law} and ${joint.pressure_law}`)));
  at('about').textContent = [
    takes.map((run) => run.name).join(' beside '),
    ...(laws.size > 0 ? [`laws ${[...laws].join('; ')}`] : []),
    ...(data.every > 1 ? [`one of ${data.every} rows of the history`] : []),
    data.program].join(' · ');
  for (const text of data.warnings) make('li', at('warnings'), text);
  if (data.warnings.length === 0) make('li', at('warnings'), 'none');
  at('case').hidden = data.case === '';
  at('case').querySelector('pre').textContent = data.case;
}

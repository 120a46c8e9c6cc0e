// Asks the engine while one types, and shows its answers.

engineWorker.onmessage = ({data: {id, json}}) => {
  waiting.get(id)(JSON.parse(json));
  waiting.delete(id);
};
engineWorker.onerror = (event) => {
  event.preventDefault();
  stopped(event.message);
};

function stopped(why) {
  byId('error').hidden = false;
  byId('error').textContent =
      `The calculator has stopped (${why}): load the page again.`;
}

const waiting = new Map();
let lastId = 0;
const ready = engineCode.then((code) => engineWorker.postMessage({code}));
async function ask(call, ...texts) {
  await ready;
  return new Promise((resolve) => {
    waiting.set(++lastId, resolve);
    engineWorker.postMessage({id: lastId, call, texts});
  });
}

// Rows beside the picture: names of numbers, and what to call them; the first
// ones in bold.
const shownNumbers = [
  ['M_t_N_m', 'Friction torque', true],
  ['M_textbook_N_m', 'Textbook torque'],
  ['f_M', 'Catalogue coefficient'],
  ['p_peak_Pa', 'Peak pressure', true],
  ['p_mean_Pa', 'Mean pressure'],
  ['p_nominal_Pa', 'Nominal pressure'],
  ['theta0_deg', 'Half-angle of the contact', true],
  ['pv_max_W_per_m2', 'Largest p v'],
  ['pv_nominal_W_per_m2', 'Nominal p v'],
  ['power_W', 'Power of friction'],
  ['R_n_N', 'Normal force'],
  ['a_deg', 'Slip axis angle'],
  ['approach_m', 'Approach'],
  ['stiffness_N_per_m', 'Stiffness'],
  ['p_0_Pa', 'Pressure of interference'],
  ['R_lift_off_N', 'Load of lift-off'],
  ['M_0_N_m', 'Torque without load'],
];
const shownCurves = [
  {title: 'Friction torque over the textbook’s', over: 'M_textbook_N_m',
   names: ['M_t_N_m', 'M_textbook_N_m'], labels: ['computed', 'textbook']},
  {title: 'Pressure', logY: true, names: ['p_peak_Pa', 'p_mean_Pa', 'p_nominal_Pa'],
   labels: ['peak', 'mean', 'nominal']},
  {title: 'Half-angle', names: ['theta0_deg'], labels: ['half-angle']},
  {title: 'Approach', logY: true, names: ['approach_m'], labels: ['approach']},
];

function showNumbers(numbers, number, {kind}) {
  const rows = new Map(numbers.map((row) => [row.name, row]));
  byId('key_numbers').replaceChildren(...shownNumbers.flatMap(
      ([name, text, main]) => {
        const row = rows.get(name);
        // Pins do not spin.
        const isTold = name === 'a_deg' && kind === 'pin';
        if (!row || isTold || number[name] === null) return [];
        const of = {class: main && 'main', title: `${row.meaning}: ${
            row.value} ${row.unit}`};
        return [make('dt', of, text + ' ', make('small', {},
                                                ...symbolOf(row.symbol))),
                make('dd', {...of, id: name}, pretty(row.value, row.unit))];
      }));
  byId('numbers').replaceChildren(...numbers.map(
      ({name, value, unit, meaning}) => make(
          'tr', {}, make('th', {scope: 'row'}, name),
          make('td', {}, value === null ? '–' : String(value)),
          make('td', {}, unit), make('td', {}, meaning))));
}

function showTexts({warnings, notes}) {
  const items = (texts) => texts.map((text) => make('li', {}, text));
  byId('warnings').replaceChildren(...items(warnings));
  byId('warnings_box').hidden = warnings.length === 0;
  byId('notes').replaceChildren(...items(notes));
  byId('notes').hidden = notes.length === 0;
}

function showWays({file, command, python, cpp}) {
  const ways = [['Joint file', file], ['Command line', command],
                ['Python', python], ['C++', cpp]];
  byId('ways').replaceChildren(...ways.map(([name, text]) => {
    const pre = make('pre', {tabindex: 0, role: 'region', 'aria-label': name,
                             class: text === command && 'wraps'}, text);
    const button = make('button', {type: 'button', 'aria-label': `Copy: ${name}`},
                        'Copy');
    button.addEventListener('click', () => copy(text, pre));
    return make('div', {class: 'way'},
                make('div', {}, make('h3', {}, name), button), pre);
  }));
}

function showCurves(answer, curves, number) {
  const units = new Map(answer.numbers.map(({name, unit}) => [name, unit]));
  const share = (value, of) => value !== null && of > 0 ? value / of : null;
  const figures = shownCurves.flatMap(({title, names, labels, logY, over}) => {
    const all = names.map((name, i) => ({
      label: labels[i],
      y: (curves[name] ?? []).map(
          (value, k) => over ? share(value, curves[over][k]) : value),
      at: over ? share(number[name], number[over]) : number[name],
    })).filter(({y}) => y.some((each) => each !== null &&
                                         (!logY || each > 0)));
    if (all.length === 0) return [];
    // Interference has a torque without load: many times the textbook's.
    const isWide = over && Math.max(...all.flatMap(({y}) => y)) > 5;
    return [chart({title, x: curves.R_N, xUnit: 'N', xLabel: 'load',
                   curves: all, unit: over ? '' : units.get(names[0]),
                   logX: true, logY: logY || isWide, here: number.R_N})];
  });
  const {theta_deg: theta, p_Pa: p} = answer.pressure;
  if (p.some((each) => each > 0)) {
    figures.push(chart({
      title: 'Pressure over the contact', x: theta, xUnit: 'deg',
      xLabel: 'angle from its centre', unit: 'Pa',
      curves: [{label: 'from the centre to the edge', y: p, at: p[0]}]}));
  }
  byId('charts').replaceChildren(...figures);
}

async function copy(text, element) {
  try {
    await navigator.clipboard.writeText(text);
    byId('copied').textContent = 'Copied.';
  } catch {
    // Without the right to write there the text is selected at least.
    getSelection().selectAllChildren(element);
    byId('copied').textContent = 'Selected: copy it with Ctrl+C.';
  }
}

let form;

// Asks and shows the answer, unless a newer question makes it late. The times
// from the key to what is seen are measures of the browser's.
async function answerOnce(isLate) {
  const start = performance.now();
  const {joint, state} = form.question;
  const slow = setTimeout(() => document.body.classList.add('computing'), 60);
  const answer = await ask('answer', joint, state);
  clearTimeout(slow);
  document.body.classList.remove('computing');
  form.say(answer.error);
  document.body.classList.toggle(
      'stale', 'error' in answer && byId('numbers').hasChildNodes());
  if ('error' in answer) {
    performance.measure('answer', {start});
    return;
  }
  const number = Object.fromEntries(
      answer.numbers.map(({name, value}) => [name, value]));
  byId('name').textContent = answer.joint.name === 'joint' ?
      'Answer' : answer.joint.name;
  showNumbers(answer.numbers, number, answer.joint);
  drawJoint(answer, number);
  showTexts(answer);
  showWays(answer.same);
  performance.measure('answer', {start});
  if (isLate()) return;
  const curves = await ask('curves', joint, state);
  if (isLate()) return;
  showCurves(answer, curves, number);
  performance.measure('curves', {start});
}

// One question at a time: of those that come meanwhile the last one counts.
let busy = false;
let again = false;
let linking;
async function update() {
  byId('copied').textContent = '';
  // Browsers allow some changes of the address a second.
  clearTimeout(linking);
  linking = setTimeout(writeLink, 300);
  again = true;
  if (busy) return;
  busy = true;
  while (again) {
    again = false;
    await answerOnce(() => again);
  }
  busy = false;
}

const writeLink = () => history.replaceState(null, '', '#' + form.link);

function changeMode() {
  if (form.own === null) {
    form.own = byId('file').value = form.question.joint;
  } else {
    form.own = null;
  }
  form.show();
  update();
}

const choices = JSON.parse(byId('choices').textContent);
form = new Form(choices);
form.set(new URLSearchParams(location.hash.slice(1)));
byId('form').addEventListener('input', ({target}) => {
  if (target.id === 'example' && target.value !== '') {
    byId('file').value = choices.joints.find(
        ({file}) => file === target.value).text;
  }
  if (form.own !== null) form.own = byId('file').value;
  form.show();
  update();
});
byId('form').addEventListener('submit', (event) => event.preventDefault());
byId('mode').addEventListener('click', changeMode);
byId('link').addEventListener('click', () => {
  writeLink();
  copy(location.href, byId('link'));
});
addEventListener('hashchange', () => {
  form.set(new URLSearchParams(location.hash.slice(1)));
  update();
});
update().catch((error) => stopped(error.message));

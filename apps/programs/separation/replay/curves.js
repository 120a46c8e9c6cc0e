// Curves over time, with a cursor.

const graphs = [];
// The legend sets style attributes, which the page's policy forbids.
Dygraph.PLUGINS =
    Dygraph.PLUGINS.filter((plugin) => plugin !== Dygraph.Plugins.Legend);

// A curve of each run; NaN leaves a gap.
function hingeCurves(quantity, dashed) {
  return takes.flatMap((run, k) => hinged.map((body) => {
    const values = run.column(`${body.column}.${quantity}`);
    const mode = run.column(`${body.column}.mode`);
    const ends = dashed ? locked : released;
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

// Counts the curves before each one that it lies on, to the eye, for a third of
// its way or more, as mirror images do. Some 200 rows are compared.
function curvesBelow(curves, logarithmic) {
  const values = curves.map(({run, at: value}) => {
    const step = Math.max(1, Math.floor(run.time.length / 200));
    return Array.from({length: Math.ceil(run.time.length / step)}, (_, i) => {
      const y = value(i * step);
      return y !== null && logarithmic ? Math.log(y) : y;
    });
  });
  const all = values.flat().filter((y) => y !== null && Number.isFinite(y));
  // Two px.
  const seen = 0.015 * (Math.max(...all) - Math.min(...all));
  const same = (a, b) => {
    const apart = values[a].map((y, i) => Math.abs(y - values[b][i]))
        .filter((_, i) => values[a][i] !== null && values[b][i] !== null);
    return apart.length > 0 &&
        3 * apart.filter((y) => y <= seen).length >= apart.length;
  };
  return curves.map((curve, i) => curves.slice(0, i).filter((other, j) =>
      other.run === curve.run && other.dashed === curve.dashed &&
      same(i, j)).length);
}

// The second, third, ... curve of those on each other has every second, fourth,
// ... dash, so that all are seen.
function strokePattern(curve, below) {
  if (curve.dashed) return [2, 3];
  if (curve.faint) return [7, 4];
  return below === 0 ? null : [6, 6 * (2 ** Math.min(below, 5) - 1)];
}

// Names beside their colours.
function addKey(parent, items) {
  const key = make('ul', parent, undefined, 'key');
  for (const [name, colour] of items) {
    const item = make('li', key);
    if (colour) make('span', item, undefined, 'swatch').style.background = colour;
    item.append(name);
  }
}

function addGraph(title, curves, unit, logarithmic) {
  const box = make('div', at('curves'), undefined, 'curve');
  make('h2', box, title);
  const place = make('div', box, undefined, 'graph');
  const style = getComputedStyle(document.documentElement);
  const options = {};
  const below = curvesBelow(curves, logarithmic);
  curves.forEach((curve, i) => {
    options[`c${i}`] = {
      strokePattern: strokePattern(curve, below[i]),
      strokeWidth: curve.faint ? 1.2 : 1.8,
    };
  });
  const rows = rowsOf(curves);
  // What ends early, as hinges do, has the width; a double click shows all.
  const has = rows.filter((row) => row.slice(1).some(Number.isFinite));
  const end = has.length > 0 ? has[has.length - 1][0] : take.end;
  const isShort = end - take.start < 0.6 * (take.end - take.start);
  const graph = new Dygraph(place, rows, {
    ...(isShort && {dateWindow: [
      take.start, end + 0.1 * (end - take.start)]}),
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
          axisLabelFormatter: (y, _, __, of) => {
            const [low, high] = of.yAxisRange();
            // Neighbours differ in the digits that are shown.
            const digits = Math.log10(Math.abs(y) / (high - low)) + 2.5;
            return show(y, unit, Math.min(9, Math.max(4, Math.ceil(digits))));
          }},
    },
    clickCallback: (event, x) => go(x),
  });
  const cursor = make('div', place, undefined, 'cursor');
  graphs.push({graph, cursor});
  return box;
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
  addKey(at('curves'), [
    ...hinged.map((body) => [body.name, body.colour]),
    ...(takes.length > 1 ?
        [[`line: ${takes[0].name}, dashed: ${takes[1].name}`]] : []),
    ...(hinged.length > 1 || data.pairs.length > 1 ?
        [['dashes of several colours: curves on each other']] : []),
  ]);
  if (hinged.length > 0) {
    addGraph('Angle of the hinge, deg', hingeCurves('angle_deg'), '');
    addGraph('Rate of the hinge, deg/s', hingeCurves('rate_deg_per_s'), '');
    const locks = data.bodies.some((body) => body.lock);
    addGraph(locks ? 'Reaction (dotted: of the lock)' : 'Reaction',
             [...hingeCurves('reaction_N'),
              ...(locks ? hingeCurves('lock_reaction_N', true) : [])], 'N');
    if (largest('friction_moment_N_m') > 0) {
      addGraph('Friction moment', hingeCurves('friction_moment_N_m'), 'N m');
    }
  }
  if (take.nearest) {
    const colour = (i) => pairColours[i % pairColours.length];
    const curves = plainCurves(
        data.pairs.map((_, i) => [pairColumn(i), colour(i)]));
    addKey(addGraph('Clearance', curves, 'm', spread(curves) > 50),
           data.pairs.map((_, i) => [pairName(i), colour(i)]));
  }
  const energies = {kinetic: '#0072b2', gravity: '#009e73',
                    active_work: '#e69f00', dissipated: '#d55e00'};
  const box = addGraph('Energy', plainCurves(Object.entries(energies).map(
      ([name, colour]) => [`energy.${name}_J`, colour])), 'J');
  addKey(box, Object.entries(energies).map(
      ([name, colour]) => [name.replace('_', ' '), colour]));
}

// Colours of pairs of bodies, as far from each other as so many can be.
const pairColours = [
  '#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#8c564b',
  '#7f3fbf', '#b5b500', '#17becf', '#e7298a', '#666666'];

function placeCursors() {
  for (const {graph, cursor} of graphs) {
    const area = graph.getArea();
    const x = graph.toDomXCoord(now);
    cursor.hidden = x < area.x || x > area.x + area.w;
    cursor.style.transform = `translate(${x}px, ${area.y}px)`;
    cursor.style.height = `${area.h}px`;
  }
}

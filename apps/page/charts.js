// Curves in pictures: lines over an axis that is linear or logarithmic, and
// the point at which the joint works.

const room = {left: 46, right: 18, top: 8, bottom: 34, width: 380, height: 190};

// Round numbers from `low` to `high`.
function ticksOf(low, high, logarithmic) {
  const ticks = [];
  if (logarithmic) {
    for (let power = Math.ceil(Math.log10(low) - 1e-9);
         power <= Math.log10(high) + 1e-9; ++power) ticks.push(10 ** power);
    return ticks;
  }
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((each) => each * power >= rough);
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9;
       ++i) ticks.push(i * step);
  return ticks;
}

const tickText = (value) => value === 0 ? '0' :
    Math.abs(value) >= 1e4 || Math.abs(value) < 1e-3 ?
        value.toExponential(0).replace('+', '').replace('-', '−') :
        String(Number(value.toPrecision(3)));

// An axis from numbers to places in the picture, in the unit that suits `size`.
function axisOf(numbers, unit, size, from, to, logarithmic) {
  const finite = numbers.filter((x) => x !== null && isFinite(x) &&
      (!logarithmic || x > 0));
  const largest = Math.max(...finite);
  const {factor, name} = scaleOf(size > 0 ? size : largest, unit);
  let [low, high] = [Math.min(...finite), largest].map((x) => x / factor);
  if (!logarithmic) [low, high] = [Math.min(low, 0), high * 1.05 || 1];
  else if (!(high > low)) [low, high] = [low / 10, low * 10];
  const bend = logarithmic ? Math.log10 : (x) => x;
  const at = (x) => from + (to - from) *
      (bend(x / factor) - bend(low)) / (bend(high) - bend(low));
  return {at, name, ticks: ticksOf(low, high, logarithmic)
      .map((x) => ({text: tickText(x), place: at(x * factor)}))};
}

function pathOf(x, y, values) {
  let path = '';
  values.x.forEach((value, i) => {
    const known = values.y[i] !== null && !(y.positive && !(values.y[i] > 0));
    if (!known) return;
    const start = path === '' || values.y[i - 1] === null;
    path += `${start ? 'M' : 'L'}${x.at(value).toFixed(1)} ` +
        `${y.at(values.y[i]).toFixed(1)}`;
  });
  return path;
}

// A figure. `curves`: [{label, y, at}], each with its symbol as nodes; `x`:
// numbers; `here`: the x of the joint's state.
function chart({title, x, xUnit, xLabel, curves, unit, logX, logY, here}) {
  const {left, right, top, bottom, width, height} = room;
  const xAxis = axisOf(x, xUnit, here, left, width - right, logX);
  const yAxis = axisOf(curves.flatMap(({y}) => y), unit, curves[0].at,
                       height - bottom, top, logY);
  yAxis.positive = logY;
  const text = `${title} over ${xLabel}: ` + curves.map(
      ({label, at}) => `${label} ${pretty(at, unit)}`).join(', ');
  const svg = draw('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img',
                           'aria-label': text});
  const line = (name, x1, y1, x2, y2) =>
      svg.append(draw('line', {class: name, x1, y1, x2, y2}));
  for (const {text: tick, place} of xAxis.ticks) {
    line('grid', place, top, place, height - bottom);
    svg.append(draw('text', {x: place, y: height - bottom + 14,
                             'text-anchor': 'middle'}, tick));
  }
  for (const {text: tick, place} of yAxis.ticks) {
    line('grid', left, place, width - right, place);
    svg.append(draw('text', {x: left - 5, y: place + 4,
                             'text-anchor': 'end'}, tick));
  }
  svg.append(draw('text', {
    x: (left + width - right) / 2, y: height - 5, 'text-anchor': 'middle',
    class: 'soft'}, xAxis.name ? `${xLabel}, ${xAxis.name}` : xLabel));
  if (here !== undefined) {
    line('here', xAxis.at(here), top, xAxis.at(here), height - bottom);
  }
  curves.forEach(({y, at}, i) => {
    svg.append(draw('path', {class: `curve_line c${i}`,
                             d: pathOf(xAxis, yAxis, {x, y})}));
    if (here === undefined || at === null || (logY && !(at > 0))) return;
    svg.append(draw('circle', {class: `at c${i}`, r: 4.5, cx: xAxis.at(here),
                               cy: yAxis.at(at)}));
  });
  const key = curves.map(({label, at}, i) => make(
      'li', {class: `c${i}`}, make('i', {class: 'swatch'}),
      `${label} ${here === undefined ? '' : pretty(at, unit)}`));
  return make('figure', {},
              make('h3', {}, yAxis.name ? `${title}, ${yAxis.name}` : title),
              make('ul', {class: 'key'}, ...key), svg);
}

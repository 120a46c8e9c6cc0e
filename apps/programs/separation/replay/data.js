// What the page of a replay (page.html) reads and how it writes it. All text goes
// into the page as text, never as markup.
const data = JSON.parse(document.getElementById('data').textContent);
const at = (id) => document.getElementById(id);
const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
const released = 3;
const locked = 2;
const modes = ['sliding', 'resting', 'locked', 'released', 'latched'];

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

// With a prefix for the units that take one: "1.234 MN".
function show(value, unit, digits = 4) {
  if (!Number.isFinite(value)) return '–';
  const prefixes = {9: 'G', 6: 'M', 3: 'k', 0: '', '-3': 'm', '-6': 'µ'};
  if (!/^(N|N m|Pa|J|m)$/.test(unit)) {
    return `${round(value, digits)}${unit ? ' ' + unit : ''}`;
  }
  const largest = unit === 'm' ? 0 : 9;
  const exponent = value === 0 ? 0 : Math.min(largest, Math.max(
      -6, 3 * Math.floor(Math.log10(Math.abs(value)) / 3)));
  return `${round(value / 10 ** exponent, digits)} ${prefixes[exponent]}${unit}`;
}
const round = (value, digits) => String(Number(value.toPrecision(digits)));
const seconds = (time) => `${time.toFixed(3)} s`;

// A run: its rows under the names of the history's columns.
class Take {
  constructor(json) {
    this.name = json.name || `friction ${json.friction}`;
    this.summary = json.summary;
    this.time = new Float64Array(bytes(json.time).buffer);
    this.packed = json.columns;
    this.columns = new Map();
    this.nearest =
        json.nearest && new Float32Array(bytes(json.nearest).buffer);
    this.forces = json.forces && new Float32Array(bytes(json.forces).buffer);
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
  // A force of the case and its moment about its point; nothing while it does
  // not act. A force that ends before the next row stays as it is until then.
  force(number) {
    const of = (row) => {
      const from = 6 * (row * data.forces.length + number);
      return [...this.forces.subarray(from, from + 6)];
    };
    const from = of(this.row);
    if (Number.isNaN(from[0])) return undefined;
    const to = this.part > 0 ? of(this.row + 1) : from;
    const part = Number.isNaN(to[0]) ? 0 : this.part;
    const is = from.map((x, i) => x + part * ((to[i] || 0) - x));
    return {force: is.slice(0, 3), moment: is.slice(3)};
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
// Events that happen at one instant, in their order.
const instants = [];
for (const event of events) {
  const last = instants[instants.length - 1];
  if (last && event.time_s - last.time <= 1e-9) last.events.push(event);
  else instants.push({time: event.time_s, events: [event]});
}
// "lower nodes break: lower node breaks" says it twice.
const eventText = ({body, what}) =>
    `${body}: ${what.replace(/^(.* breaks?): .* breaks$/, '$1')}`;
// Bodies to which the same happens are named together.
const instantText = ({time, events: all}) => {
  const bodies = new Map(all.map(({what}) => [what, []]));
  for (const {body, what} of all) bodies.get(what).push(body);
  const texts = [...bodies].map(
      ([what, names]) => eventText({body: names.join(', '), what}));
  return `${seconds(time)}  ${texts.join(' · ')}`;
};
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

// Numbers for people: four digits, with a prefix of the unit.

const prefixes = [[1e9, 'G'], [1e6, 'M'], [1e3, 'k'], [1, ''], [1e-3, 'm'],
                  [1e-6, 'µ'], [1e-9, 'n']];
// p v is known in units of pressure times speed.
const shownUnits = {'W/m^2': 'Pa m/s', deg: '°', 'm^2': 'm²', 'N m': 'N m'};
const unprefixed = ['', 'deg', 'rad/s'];

// The factor and the name of the unit that suits numbers up to `largest`.
function scaleOf(largest, unit) {
  const name = shownUnits[unit] ?? unit;
  if (unprefixed.includes(unit) || !(largest > 0) || !isFinite(largest)) {
    return {factor: 1, name};
  }
  if (unit === 'm^2') return {factor: 1e-6, name: 'mm²'};
  const [factor, prefix] =
      prefixes.find(([size]) => largest >= size) ?? prefixes.at(-1);
  return {factor, name: prefix + name};
}

function digits(value) {
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = size >= 1e-3 && size < 9999.5 ? value.toPrecision(4) :
      value.toExponential(3);
  return text.replace('-', '−');
}

function pretty(value, unit) {
  if (value === null || value === undefined) return '–';
  if (typeof value === 'string') return value.replace('inf', '∞');
  const {factor, name} = scaleOf(Math.abs(value), unit);
  const text = digits(value / factor);
  return name === '°' ? text + '°' : name ? `${text} ${name}` : text;
}

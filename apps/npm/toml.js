// The text of a joint file from an object with its keys.
const isTable = (x) => typeof x === 'object' && !Array.isArray(x);
const nameOf = (key) => /^[\w-]+$/.test(key) ? key : JSON.stringify(key);

// Whole numbers that TOML's integers do not hold have an exponent.
const numberOf = (x) => Number.isInteger(x) && !Number.isSafeInteger(x) ?
    x.toExponential() :
    String(x).replace('Infinity', 'inf').replace('NaN', 'nan');
const valueOf = (x) => Array.isArray(x) ? `[${x.map(valueOf)}]` :
    typeof x === 'number' ? numberOf(x) : JSON.stringify(x);

export function toml(object, path = '') {
  let own = '';
  let below = '';
  for (const [key, x] of Object.entries(object)) {
    if (x === undefined || x === null) continue;
    const name = path + nameOf(key);
    const tables = [x].flat();
    if (tables.length > 0 && tables.every(isTable)) {
      const head = Array.isArray(x) ? `[[${name}]]` : `[${name}]`;
      for (const each of tables) {
        below += `${head}\n${toml(each, `${name}.`)}`;
      }
    } else {
      own += `${nameOf(key)} = ${valueOf(x)}\n`;
    }
  }
  return own + below;
}

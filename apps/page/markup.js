// Elements; texts go into them as texts alone.

const byId = (id) => document.getElementById(id);

function filled(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) {
      element.setAttribute(name, value === true ? '' : value);
    }
  }
  element.append(...children);
  return element;
}
const make = (name, attributes = {}, ...children) =>
    filled(document.createElement(name), attributes, children);
const draw = (name, attributes = {}, ...children) =>
    filled(document.createElementNS('http://www.w3.org/2000/svg', name),
           attributes, children);

// Symbols as the library has them: M_t with its index, theta0 in Greek; none of
// those that are words.
function symbolOf(symbol) {
  const text = symbol.replace('theta0', 'θ0').replace('rho', 'ρ');
  const match = /^(\w{1,2})_(\w+)$/.exec(text);
  if (match) return [match[1], make('sub', {}, match[2])];
  return text.length < 3 || text.includes(' ') ? [text] : [];
}

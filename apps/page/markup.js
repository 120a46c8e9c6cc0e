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

// Symbols as the library has them: M_t with its index, theta0 in Greek.
const greek = {theta0: 'θ0', Dw: 'Δω', rho: 'ρ'};
function symbolOf(symbol) {
  const text = symbol.replace(/theta0|Dw|rho/g, (name) => greek[name]);
  const match = /^(\w)_(\w+)$/.exec(text);
  return match ? [match[1], make('sub', {}, match[2])] : [text];
}

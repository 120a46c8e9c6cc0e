// The joint cut through its middle, the contact at the bottom: half-angle,
// pressure, layers and slip axis to scale, the clearance too wide.

const ballRadius = 100;
const gap = 5;

// From the centre of a circle, the angle from straight down.
const onCircle = (radius, angle, y = 0) =>
    [radius * Math.sin(angle), y + radius * Math.cos(angle)];
const places = (points) =>
    points.map((p) => p.map((c) => c.toFixed(2)).join(' ')).join('L');
const arcOf = (radius, from, to, y = 0) => Array.from(
    {length: 97}, (_, i) => onCircle(radius, from + (to - from) * i / 96, y));
// Part of a ring, or all of it: then its two edges are paths of their own.
const ring = (name, inner, outer, half, y) => draw('path', {
  class: name, 'fill-rule': 'evenodd',
  d: `M${places(arcOf(inner, -half, half, y))}${half < Math.PI ? 'L' : 'ZM'}${
    places(arcOf(outer, half, -half, y))}Z`});

function arrow(line, tip, [x1, y1], [x2, y2]) {
  const length = Math.hypot(x2 - x1, y2 - y1);
  const [ux, uy] = [(x2 - x1) / length, (y2 - y1) / length];
  const head = [[x2, y2], [x2 - 9 * ux - 4 * uy, y2 - 9 * uy + 4 * ux],
                [x2 - 9 * ux + 4 * uy, y2 - 9 * uy - 4 * ux]];
  return [draw('path', {class: line, d: `M${places([[x1, y1], [x2, y2]])}`}),
          draw('path', {class: tip, d: `M${places(head)}Z`})];
}

// A symbol with its index.
function label(text, [x, y], anchor = 'middle', index = '') {
  return draw('text', {x, y, 'text-anchor': anchor}, text,
              draw('tspan', {class: 'index', dy: 3}, index));
}

// The seat or hole about the ball or pin, its layers from the contact on.
function seatOf(joint, isPin) {
  const half = isPin ? Math.PI : 1.9;
  const parts = [];
  let radius = ballRadius + gap;
  for (const {thickness_m: thickness} of joint.layers) {
    const width = Math.max(thickness / joint.radius_m * ballRadius, 3);
    if (radius + width > 140) break;
    parts.push(ring('layer', radius, radius + width, half, -gap));
    radius += width;
  }
  return [ring('outer', radius, 150, half, -gap), ...parts];
}

// The pressure on the surface, inwards from it.
function pressureOf({theta_deg: theta, p_Pa: p}) {
  const largest = Math.max(...p);
  if (!(largest > 0)) return [];
  const inner = theta.map((t, i) =>
      onCircle(ballRadius - 42 * p[i] / largest, t * Math.PI / 180));
  const mirrored = inner.map(([x, y]) => [-x, y]).reverse();
  const half = theta.at(-1) * Math.PI / 180;
  return [draw('path', {
    class: 'pressed',
    d: `M${places([...mirrored, ...inner, ...arcOf(ballRadius, half, -half)])}Z`,
  })];
}

function axisOfSlip(isPin, angle, moves) {
  if (isPin) {
    return [draw('circle', {class: 'axis', r: 7}),
            draw('circle', {class: 'axis_tip', r: 2.5}),
            label('Δω', [-18, -8])];
  }
  if (!moves) return [];
  const along = (length) => [length * Math.cos(angle), length * Math.sin(angle)];
  const [x, y] = along(-128);
  return [...arrow('axis', 'axis_tip', along(-118), along(128)),
          label('Δω', [x - 4, y - 8])];
}

// Draws an answer; numbers by their names.
function drawJoint({joint, pressure, words}, number) {
  const svg = byId('picture');
  const isPin = joint.kind === 'pin';
  const half = (number.theta0_deg ?? 0) * Math.PI / 180;
  const loaded = number.R_n_N > 0;
  const parts = [...seatOf(joint, isPin),
                 draw('circle', {class: 'inner', r: ballRadius})];
  if (half > 0) {
    parts.push(...pressureOf(pressure), draw('path', {
      class: 'touch', d: `M${places(arcOf(ballRadius + 1, -half, half))}`}));
    if (half < Math.PI) {
      parts.push(draw('path', {class: 'aid', d: `M${places(
          [onCircle(ballRadius, -half), [0, 0], onCircle(ballRadius, half)])}`}));
      // Beside the line where there is no room between both.
      const place = half < .6 ? half + .15 : Math.min(half, 1.2) / 2;
      parts.push(draw('path', {class: 'aid', d: `M${places(
          arcOf(30, 0, half))}`}),
                 label('θ', onCircle(42, place), 'start', '0'));
    }
  }
  const slides = words.state === 'sliding';
  parts.push(...axisOfSlip(isPin, (number.a_deg ?? 0) * Math.PI / 180, slides));
  if (loaded) {
    parts.push(...arrow('force', 'tip', [0, -88], [0, -30]),
               label('R', [6, -72], 'start', 'n'));
    if (isPin && number.R_t_N > 0) {
      // To the scale of R_n.
      const width = 58 * number.R_t_N / number.R_n_N;
      if (width > 12) {
        parts.push(...arrow('force', 'tip', [0, -30], [Math.min(width, 90), -30]),
                   label('R', [Math.min(width, 90) + 4, -26], 'start', 't'));
      }
    }
  }
  svg.replaceChildren(...parts);
  const scale = pretty(joint.radius_m * 2, 'm');
  byId('picture_text').textContent = `${isPin ?
      'Across the pin, of' : 'Through the contact’s centre and the slip axis; ball of'
    } ${scale} diameter. Contact of half-angle ${
    pretty(number.theta0_deg, 'deg')}, ${words.contact_state === 'closed' ?
        'closed all round' : 'pressure drawn inwards from it'}.`;
}

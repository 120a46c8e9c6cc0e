// The form, which writes a joint file and a state; messages of their reader
// name the key at fault, and so the field.

// Fields with a key of the joint file or of the state. `units`: the dimension
// whose endings the key takes; `ending`: the only one.
function fieldsOf(choices) {
  const named = ({file, text}) =>
      [file, /^name = "(.*)"$/m.exec(text)?.[1] ?? file];
  const has = (name, ...values) => (v) => values.includes(v[name]);
  const both = (...all) => (v) => all.every((each) => each(v));
  const sized = has('by', 'size', 'fit');
  const numbers = has('pair', 'numbers');
  const walled = has('wall', 'layer');
  const isBall = has('kind', 'ball');
  const coated = has('coating', 'one');
  const viscous = has('friction', 'viscous');
  const warm = has('warm', 'another');
  const solid = (v) => !['rigid', 'held'].includes(v.backing);
  return [
    {id: 'kind', label: 'Kind', key: 'kind', of: ['pin', 'ball']},
    {id: 'by', label: 'Size by', of: [
      ['size', 'diameter and clearance'], ['fit', 'diameter and ISO 286 fit'],
      ['designation', 'bearing designation']]},
    {id: 'diameter', label: 'Diameter', key: 'geometry.diameter', value: '40',
     units: 'length', unit: 'mm', when: sized},
    {id: 'clearance', label: 'Diametral clearance', value: '50',
     key: 'geometry.diametral_clearance', units: 'length', unit: 'um',
     when: has('by', 'size')},
    {id: 'hole', label: 'Seat or hole', key: 'geometry.hole', value: 'H7',
     text: true, when: has('by', 'fit')},
    {id: 'shaft', label: 'Ball or pin', key: 'geometry.shaft', value: 'g6',
     text: true, when: has('by', 'fit')},
    {id: 'designation', label: 'Designation', key: 'geometry.designation',
     value: 'GE50ES', text: true, when: has('by', 'designation')},
    {id: 'group', label: 'Clearance group', key: 'geometry.clearance_group',
     of: ['C2', 'CN', 'C3'], value: 'CN', when: has('by', 'designation')},
    {id: 'taken', label: 'Clearance taken', key: 'geometry.clearance',
     of: ['minimum', 'mean', 'maximum'], value: 'mean',
     when: has('by', 'fit', 'designation')},
    {id: 'length', label: 'Length', key: 'geometry.length', value: '40',
     units: 'length', unit: 'mm', when: has('kind', 'pin')},
    {id: 'seat', label: 'Seat', when: both(isBall, sized), of: [
      ['none', 'beyond the contact'], ['cup', 'cup'], ['ring', 'ring']]},
    {id: 'cup', label: 'Cup, half-angle', key: 'seat.cup_deg', value: '90',
     unit: '°', when: both(isBall, sized, has('seat', 'cup'))},
    {id: 'ring', label: 'Ring, width', key: 'seat.ring_width', value: '28',
     units: 'length', unit: 'mm', when: both(isBall, sized, has('seat', 'ring'))},
    {id: 'pair', label: 'Materials', value: 'steel_bronze.toml',
     of: [...choices.pairs.map(named), ['numbers', 'by numbers']]},
    ...[['inner', 'Ball or pin', '207', '0.292'],
        ['outer', 'Seat or hole', '111', '0.349']].flatMap(
        ([body, label, modulus, ratio]) => [
          {id: `${body}_modulus`, label: `${label}, E`, value: modulus,
           key: `materials.${body}.youngs_modulus`, units: 'stress',
           unit: 'GPa', when: numbers},
          {id: `${body}_ratio`, label: `${label}, ν`, value: ratio,
           key: `materials.${body}.poissons_ratio`, when: numbers}]),
    {id: 'wall', label: 'Wall', of: [
      ['none', 'no end: one material'], ['layer', 'liner or wall on a backing']]},
    {id: 'thickness', label: 'Thickness', key: 'wall.layer.thickness',
     value: '0.4', units: 'length', unit: 'mm', when: walled},
    {id: 'backing', label: 'Backing', value: 'carbon_steel.toml', when: walled,
     of: ['rigid', 'held', ...choices.backings.map(named),
          ['numbers', 'by numbers']]},
    {id: 'backing_modulus', label: 'Backing, E', value: '70',
     key: 'wall.backing.youngs_modulus', units: 'stress', unit: 'GPa',
     when: both(walled, has('backing', 'numbers'))},
    {id: 'backing_ratio', label: 'Backing, ν', value: '0.33',
     key: 'wall.backing.poissons_ratio',
     when: both(walled, has('backing', 'numbers'))},
    {id: 'coating', label: 'Coating', of: [
      ['none', 'none'], ['one', 'on the ball or pin']]},
    {id: 'coating_thickness', label: 'Coating, thickness', value: '3',
     key: 'coating.thickness', units: 'length', unit: 'um', when: coated},
    {id: 'coating_modulus', label: 'Coating, E', value: '300', when: coated,
     key: 'coating.youngs_modulus', units: 'stress', unit: 'GPa'},
    {id: 'coating_ratio', label: 'Coating, ν', value: '0.25', when: coated,
     key: 'coating.poissons_ratio'},
    {id: 'warm', label: 'Temperature', of: [
      ['none', '20 °C, as sizes'], ['another', 'another']]},
    {id: 'temperature', label: 'Of both bodies', key: 'temperature', value: '80',
     units: 'temperature', unit: 'C', when: warm},
    ...[['materials.inner', 'Ball or pin', '11.5e-6', warm],
        ['materials.outer', 'Seat or hole', '18e-6', warm],
        ['wall.backing', 'Backing', '11.5e-6', both(warm, walled, solid)],
        ['coating', 'Coating', '9e-6', both(warm, coated)]].map(
        ([table, label, value, when]) => (
          {id: `${table.replace('.', '_')}_expansion`, label: `${label}, α`,
           value, key: `${table}.thermal_expansion_per_K`, unit: '1/K', when})),
    {id: 'friction', label: 'Friction', value: 'coefficient', of: [
      ['coefficient', 'coefficient'], ['viscous', 'viscous'],
      ...choices.presets.map(({name, least, largest}) => [
        name, `${name.replaceAll('_', ' ')}, ${least} to ${largest}`])]},
    {id: 'coefficient', label: 'Coefficient f0', value: '0.1',
     key: 'friction.coefficient', when: has('friction', 'coefficient')},
    {id: 'adhesion', label: 'Adhesion A', value: '0', units: 'stress',
     unit: 'MPa', key: 'friction.adhesion',
     when: has('friction', 'coefficient')},
    {id: 'viscous', label: 'Viscous, k0', value: '1e4', unit: 'Pa s/m',
     key: 'friction.viscous_constant_Pa_s_per_m', when: viscous},
    {id: 'viscous_slope', label: 'by pressure, k1', value: '0', unit: 's/m',
     key: 'friction.viscous_pressure_slope_s_per_m', when: viscous},
    {id: 'share', label: 'Share of the range', value: '0.5',
     key: 'friction.preset_share', when: isPreset},
    {id: 'load', label: 'Load (reaction)', key: 'reaction', value: '10',
     units: 'force', unit: 'kN', state: true},
    {id: 'rate', label: 'Speed', key: 'rate', value: '10', state: true,
     units: 'angular_velocity', unit: 'deg_per_s'},
    {id: 'beta', label: 'Load to rotation axis, b', key: 'beta_deg', value: '90', unit: '°',
     state: true, when: isBall},
  ];
}

// Friction by the name of the surfaces.
const isPreset = (values) =>
    !['coefficient', 'viscous'].includes(values.friction);

// A number as TOML has it; what is none as a text, which its reader refuses.
function tomlNumber(text) {
  const plain = text.trim();
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)) {
    return /^inf$/i.test(plain) ? 'inf' : JSON.stringify(plain);
  }
  const value = Number(plain);
  if (!isFinite(value)) return value > 0 ? 'inf' : '-inf';
  return Math.abs(value) >= 1e15 ? value.toExponential() : String(value);
}

// The material pair of a list as [materials] of a joint: without its comments,
// its name and its friction.
const materialsOf = (text) => text.replace(/^#.*\n/gm, '')
    .replace(/\[friction\][^]*/, '').replace(/^[^[]*/, '')
    .replace(/^\[/gm, '[materials.').trimEnd() + '\n';

class Form {
  constructor(choices) {
    this.choices = choices;
    this.fields = fieldsOf(choices);
    for (const field of this.fields) this.#build(field);
    byId('example').append(make('option', {value: ''}, '–'), ...choices.joints.map(
        ({file}) => make('option', {value: file}, file.replace('.toml', ''))));
  }

  #build(field) {
    const {id, label, of} = field;
    field.said = make('p', {class: 'said', id: `${id}_said`, hidden: true});
    const attributes = {id, 'aria-describedby': `${id}_said`};
    if (of) {
      field.input = make('select', attributes, ...of.map((choice) => {
        const [value, text] = [choice].flat();
        return make('option', {value}, text ?? value);
      }));
      // Texts that the place beside the label would cut.
      const longest = Math.max(...[...field.input.options].map(
          ({text}) => text.length));
      field.input.classList.toggle('long_input', longest > 22);
    } else {
      field.input = make('input', {
        ...attributes, inputmode: field.text ? 'text' : 'decimal',
        spellcheck: 'false', autocapitalize: 'off'});
    }
    const units = this.choices.units[field.units];
    if (units) {
      field.unitInput = make(
          'select', {id: `${id}_unit`, class: 'unit',
                     'aria-label': `Unit of: ${label}`},
          ...units.map(({ending, symbol}) => make(
              'option', {value: ending}, symbol.replace(/^um$/, 'µm'))));
    } else if (!field.unit) {
      field.input.classList.add('wide_input');
    }
    const name = make('label', {for: id}, label);
    field.row = make('div', {class: 'field'}, name, field.input,
                     field.unitInput ?? make('span', {class: 'unit'},
                                             field.unit ?? ''), field.said);
    if (!field.unit) field.row.children[2].remove();
    byId(field.state ? 'state_fields' : 'joint_fields').append(field.row);
  }

  // Texts of all fields; those of a link, which may be forged, where they are
  // among the choices.
  set(given) {
    this.own = given.has('file') ? given.get('file').slice(0, 1e5) : null;
    for (const {id, input, unitInput, of, unit, value} of this.fields) {
      const choose = (select, text, otherwise) => {
        const known = [...select.options].some((o) => o.value === text);
        select.value = known ? text : otherwise;
      };
      const otherwise = value ?? [of?.[0]].flat()[0];
      const text = given.get(id)?.slice(0, 200);
      if (of) choose(input, text, otherwise);
      else input.value = text ?? otherwise;
      if (unitInput) choose(unitInput, given.get(`${id}_unit`), unit);
    }
    if (this.own !== null) byId('file').value = this.own;
    this.show();
  }

  get values() {
    return Object.fromEntries(
        this.fields.map(({id, input}) => [id, input.value]));
  }

  isShown(field, values) {
    if (this.own !== null) {
      if (!field.state) return false;
      return field.id !== 'beta' || !this.#fileIsOfPin();
    }
    return !field.when || field.when(values);
  }

  #fileIsOfPin() {
    return /^\s*kind\s*=\s*["']pin["']/m.test(this.own);
  }

  // Fields that count, and the file in place of them.
  show() {
    const {values} = this;
    for (const field of this.fields) {
      field.row.hidden = !this.isShown(field, values);
    }
    byId('joint_fields').hidden = this.own !== null;
    byId('own_file').hidden = this.own === null;
    byId('mode').setAttribute('aria-pressed', this.own !== null);
    byId('mode').textContent = this.own === null ?
        'Edit as joint file' : 'Back to the form';
  }

  get question() {
    const {values} = this;
    const lines = (state) => {
      const tables = new Map();
      for (const field of this.fields) {
        const {key, input, unitInput, of, text} = field;
        if (!key || Boolean(field.state) !== state ||
            !this.isShown(field, values)) continue;
        const cut = key.lastIndexOf('.');
        const table = key.slice(0, Math.max(cut, 0));
        const name = key.slice(cut + 1) +
            (unitInput?.value ? '_' + unitInput.value : '');
        const value = of || text ? JSON.stringify(input.value) :
            tomlNumber(input.value);
        tables.set(table, (tables.get(table) ?? '') + `${name} = ${value}\n`);
      }
      return tables;
    };
    const state = lines(true).get('') ?? '';
    return {joint: this.own ?? this.#file(values, lines(false)), state};
  }

  #file(values, tables) {
    const file = (list, name) =>
        this.choices[list].find((each) => each.file === name)?.text ?? '';
    if (isPreset(values)) {
      tables.set('friction', `preset = ${JSON.stringify(values.friction)}\n` +
          tables.get('friction'));
    }
    let pair = '';
    if (values.pair !== 'numbers') {
      // With what the form adds to it.
      pair = '\n' + materialsOf(file('pairs', values.pair)).replace(
          /\[(materials\.(?:inner|outer))\]\n/g,
          (head, name) => head + (tables.get(name) ?? ''));
      tables.delete('materials.inner');
      tables.delete('materials.outer');
    }
    if (values.wall === 'layer' && values.backing !== 'numbers') {
      const text = file('backings', values.backing).replace(/^#.*\n/gm, '');
      if (text) tables.set('wall.backing', text + (tables.get('wall.backing') ?? ''));
      else tables.set('wall', `backing = ${JSON.stringify(values.backing)}\n`);
    }
    let text = 'name = "joint"\n' + (tables.get('') ?? '');
    tables.delete('');
    for (const name of ['geometry', 'seat', 'materials.inner', 'materials.outer',
                        'wall', 'wall.backing', 'wall.layer', 'coating',
                        'friction']) {
      if (name === 'wall') text += pair;
      if (!tables.has(name)) continue;
      const head = ['wall.layer', 'coating'].includes(name) ?
          `[[${name}]]` : `[${name}]`;
      text += `\n${head}\n${tables.get(name)}`;
    }
    // Which alone knows the approach.
    return text + '\n[half_angle]\nlaw = "exact"\n';
  }

  // A message beside the field whose key it names, else below the form.
  say(message) {
    const {values} = this;
    const plain = message?.replace(/\[\d+\]/g, '');
    const at = message === undefined ? undefined : this.fields
        .filter((field) => field.key && this.isShown(field, values) &&
            plain.includes(field.key))
        .sort((a, b) => b.key.length - a.key.length)[0];
    for (const field of this.fields) {
      field.said.hidden = field !== at;
      field.said.textContent = field === at ? message : '';
      field.input.toggleAttribute('aria-invalid', field === at);
      if (field === at) field.input.setAttribute('aria-invalid', 'true');
    }
    const box = byId('error');
    box.hidden = message === undefined || at !== undefined;
    box.textContent = box.hidden ? '' : message;
    const isOfFile = !box.hidden && this.own !== null;
    byId('file').toggleAttribute('aria-invalid', isOfFile);
    if (isOfFile) byId('file').setAttribute('aria-invalid', 'true');
  }

  // The inputs as the part of a link behind its #: what is not as at first.
  get link() {
    const {values} = this;
    const link = new URLSearchParams();
    if (this.own !== null) link.set('file', this.own);
    for (const field of this.fields) {
      if (!this.isShown(field, values)) continue;
      const {id, input, unitInput, of, unit, value} = field;
      if (input.value !== (value ?? [of?.[0]].flat()[0])) {
        link.set(id, input.value);
      }
      if (unitInput && unitInput.value !== unit) {
        link.set(`${id}_unit`, unitInput.value);
      }
    }
    return link.toString();
  }
}

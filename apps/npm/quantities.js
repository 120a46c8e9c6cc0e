// Tables of quantities, and their values by keys.
const WORDS = {
  state: ['sliding', 'resting', 'unloaded'],
  contact_state: ['closed', 'lifted', 'zero', 'clearance'],
  holds: [false, true],
};

export function quantitiesOf(c, m) {
  const table = (row) => {
    const all = [];
    for (let i = 0, at; (at = row(i)); ++i) {
      const [key, symbol, unit, meaning, size] =
          m.heap().words.slice(at / 4, at / 4 + 5);
      all.push({key: m.read(key), symbol: m.read(symbol), unit: m.read(unit),
                meaning: m.read(meaning), size});
    }
    return all;
  };
  const tables = {
    joint: table(c.contact_joint_quantity),
    solution: table(c.contact_solution_quantity),
    rest: table(c.contact_rest_quantity),
    patch: table(c.contact_patch_quantity),
    rating: table(c.contact_rating_quantity),
  };
  const value = ({key, size}, at) => {
    if (size === 3) return Array.from(m.view(at, 3));
    const [number] = m.view(at, 1);
    return WORDS[key]?.[number] ?? number;
  };
  // Texts and lists of keys stay, for the next call with them.
  const texts = new Map();
  const textOf = (key) => {
    if (!texts.has(key)) texts.set(key, m.text(key));
    return texts.get(key);
  };
  const lists = new Map();
  return {
    tables, value,
    // Calls return the status themselves.
    keysOf: (all) => all.map(({key}) => key).filter((key) => key !== 'status'),
    // Keys that are not there are for C to refuse.
    listOf(keys) {
      const name = keys.join();
      if (!lists.has(name)) {
        lists.set(name, {
          all: keys.map((key) => tables.joint.find((q) => q.key === key) ??
              {key, size: 1}),
          at: m.words(keys.map(textOf)), values: m.made(24 * keys.length + 8)});
      }
      return lists.get(name);
    },
    // An object of quantities, which get(key, place) puts one by one.
    oneByOne: (all, keys, get) => m.during((keep) => {
      const at = keep(m.made(24));
      return Object.fromEntries(keys.map((key) => {
        m.must(get(textOf(key), at));
        return [key, value(all.find((q) => q.key === key), at)];
      }));
    }),
  };
}

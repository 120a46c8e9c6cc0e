import {ROOM} from './memory.js';
import {toml} from './toml.js';

const OF_PATCH = ['half_angle', 'load_parameter', 'peak_pressure',
                  'mean_pressure', 'contact_area'];

export function jointOf(c, m, quantities) {
  const {tables, value, keysOf, listOf, oneByOne} = quantities;

  return class Joint {
    #at;
    #memory;
    #step;
    #hasStep = false;
    #keys;
    #release;

    constructor(joint, settings = {}) {
      const isText = typeof joint === 'string';
      m.during((keep) => {
        const pairs = Object.entries(settings).flat();
        const place = keep(m.made(4));
        const status = c.contact_joint_parse(
            keep(m.text(isText ? joint : toml({name: 'joint', ...joint}))),
            keep(m.text('/data/joints')),
            keep(m.words(pairs.map((x) => keep(m.text(String(x)))))),
            pairs.length / 2, place);
        try {
          m.must(status);
        } catch (error) {  // an object has no lines
          if (!isText) {
            error.message = error.message.replace(/^joint(:\d+)*: /, '');
          }
          throw error;
        }
        this.#at = m.word(place);
        m.must(c.contact_memory_make(place));
        this.#memory = m.word(place);
        this.#readSize(keep(m.made(48)));
      });
      this.#step = m.made(ROOM.step);
      this.#keys = keysOf(this.has_seat ? tables.joint : tables.solution);
      this.#release = m.own(
          this, [c.contact_joint_free, this.#at],
          [c.contact_memory_free, this.#memory], [c.free, this.#step]);
    }
    #readSize(at) {
      m.must(c.contact_joint_get_size(this.#at, at));
      this.kind = m.word(at) ? 'pin' : 'ball';
      this.body_has_inner = m.word(at + 4) !== 0;
      [this.radius, this.radial_clearance, this.length, this.effective_modulus] =
          m.view(at + 8, 4);
      this.has_seat = m.word(at + 40) !== 0;
    }
    free() {
      this.#release();
      this.#at = this.#memory = this.#step = 0;
    }
    get handle() {
      return this.#at;
    }

    // Calls done(row, status), and use(quantity, its place, row) for each.
    #solve(n, reactions, rates, options, done, use) {
      const {axis, placement, warm} = options;
      const keys = (options.keys ?? this.#keys).filter((k) => k !== 'status');
      const {all, at, values} = listOf(keys);
      const row = (v, i) => v.length === 3 ? v : v.slice(3 * i, 3 * i + 3);
      m.during((keep) => {
        const slip = keep(m.vectors([], [], axis));
        const placed = placement ? keep(this.#placed(placement)) : 0;
        for (let i = 0; i < n; ++i) {
          m.put(m.put(slip, row(reactions, i)) + 24, row(rates, i));
          done(i, m.must(c.contact_joint_get(
              this.#at, slip, placed, warm ? this.#memory : 0, at, keys.length,
              values)));
          let from = values;
          for (const q of all) {
            use(q, from, i);
            from += 8 * q.size;
          }
        }
      });
    }
    #placed({from_seat, tilt, place, axial_velocity = 0}) {
      const at = m.made(128);
      m.put(at + 8, from_seat && m.sized(from_seat, 9, 'from_seat'));
      m.put(at + 80, m.vector(tilt));
      m.put(at + 112, [place ?? 0, axial_velocity]);
      m.heap().words[at / 4] = 128;
      m.heap().words[at / 4 + 26] = place === undefined ? 0 : 1;
      return at;
    }
    solve(reaction, rate, options = {}) {
      const result = {};
      m.sized(reaction, 3, 'the reaction');
      m.sized(rate, 3, 'the rate');
      this.#solve(1, reaction, rate, options,
          (i, status) => { result.status = status; },
          (q, at) => { result[q.key] = value(q, at); });
      return result;
    }
    solveRows(reactions, rates, options = {}) {
      const n = Math.floor(Math.max(reactions.length, rates.length) / 3);
      const result = {status: new Array(n)};
      for (const v of [reactions, rates]) {
        if (v.length !== 3) m.sized(v, 3 * n, 'reactions and rates');
      }
      this.#solve(n, reactions, rates, options,
          (i, status) => { result.status[i] = status; },
          (q, at, i) => {
            result[q.key] ??= new Float64Array(n * q.size);
            result[q.key].set(m.view(at, q.size), i * q.size);
          });
      return result;
    }

    atRest(reaction, moment, {axis} = {}) {
      return m.during((keep) => {
        const rest = keep(m.made(ROOM.rest));
        const status = m.must(c.contact_joint_at_rest(
            this.#at, keep(m.vectors(reaction, moment, axis)), 0, rest));
        return {status, ...oneByOne(tables.rest, keysOf(tables.rest),
            (key, to) => c.contact_rest_get(rest, key, to))};
      });
    }
    step({reaction, angular_velocity, free, axis}, inertia) {
      const step = this.#step;
      m.during((keep) => m.must(c.contact_joint_step(
          this.#at, keep(m.vectors(reaction, angular_velocity, free, axis)),
          keep(m.numbers(m.sized(inertia, 9, 'inertia'))), this.#hasStep ? step : 0, step)));
      this.#hasStep = true;
      return m.stepAt(step);
    }

    patch(load, keys = OF_PATCH) {
      return oneByOne(tables.patch, keys,
          (key, to) => c.contact_patch_get(this.#at, load, key, to));
    }
    pressure(load, theta) {
      return m.during((keep) => {
        const at = keep(m.made(8));
        m.must(c.contact_joint_pressure(this.#at, load, theta, at));
        return m.view(at, 1)[0];
      });
    }
    // use(slip, solution, keep) of a slip.
    #solved(reaction, rate, axis, use) {
      return m.during((keep) => {
        const slip = keep(m.vectors(reaction, rate, axis));
        const solution = keep(m.made(ROOM.solution));
        m.must(c.contact_joint_solve(this.#at, slip, 0, solution));
        return use(slip, solution, keep);
      });
    }
    rating(reaction, rate, {axis} = {}) {
      return this.#solved(reaction, rate, axis, (slip, solution) => oneByOne(
          tables.rating, keysOf(tables.rating), (key, to) =>
            c.contact_rating_get(this.#at, slip, solution, key, to)));
    }
    notes(reaction, rate, {axis} = {}) {
      const all = [];
      for (let i = 0, at; (at = c.contact_joint_note(this.#at, i)); ++i) {
        all.push(m.read(at));
      }
      if (!reaction) return all;
      return this.#solved(reaction, rate, axis, (slip, solution, keep) => {
        const of = oneByOne(tables.solution, ['half_angle', 'peak_pressure'],
            (key, to) => c.contact_solution_get(solution, key, to));
        const at = keep(m.made(ROOM.notes));
        const add = (status) => {
          m.must(status);
          all.push(...m.read(at).split('\n').filter((line) => line));
        };
        add(c.contact_joint_contact_notes(
            this.#at, of.half_angle, of.peak_pressure, at, ROOM.notes));
        add(c.contact_joint_solution_notes(this.#at, solution, at, ROOM.notes));
        return all;
      });
    }
  };
}

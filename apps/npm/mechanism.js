// Steps of a simulator's joints in its own rates: libcontact/c/mechanism.h.
import {ROOM} from './memory.js';

const START = 120;  // bytes of a contact_mechanism_start

export const mechanismOf = (c, m) => class Mechanism {
  #at;
  #size;
  #joints;  // which have to stay
  #step;
  #release;

  constructor(joints, size) {
    this.#joints = joints.map(({joint}) => joint);
    this.#size = size;
    this.#at = m.during((keep) => {
      const place = keep(m.made(4));
      m.must(c.contact_mechanism_make(
          keep(m.words(joints.flatMap(({joint, first}) => [joint.handle, first]))),
          joints.length, size, place));
      return m.word(place);
    });
    this.#step = m.made(ROOM.step);
    this.#release = m.own(
        this, [c.contact_mechanism_free, this.#at], [c.free, this.#step]);
  }
  free() {
    this.#release();
    this.#at = this.#step = 0;
  }
  weigh(inertia, rows, stiffness, timeStep) {
    m.sized(inertia, this.#size ** 2, 'inertia');
    m.sized(rows, stiffness.length * this.#size, 'rows');
    m.during((keep) => m.must(c.contact_mechanism_weigh(
        this.#at, keep(m.numbers(inertia)), keep(m.numbers(rows)),
        keep(m.numbers(stiffness)), stiffness.length, timeStep)));
  }
  #rates(values, name) {
    return m.numbers(m.sized(values, this.#size, name));
  }
  begin(starts, rates, likely) {
    m.sized(starts, this.#joints.length, 'starts, each of a joint,');
    m.during((keep) => {
      const all = keep(m.made(START * this.#joints.length));
      starts.forEach(({reaction, axis, from_seat}, i) => {
        const at = m.put(all + START * i, m.vector(reaction));
        m.put(at + 24, m.vector(axis));
        m.put(at + 48, from_seat && m.sized(from_seat, 9, 'from_seat'));
      });
      m.must(c.contact_mechanism_begin(
          this.#at, all, keep(this.#rates(rates, 'rates')),
          keep(this.#rates(likely, 'likely'))));
    });
  }
  turn(ratesAtEnd, force) {
    return m.during((keep) => {
      const at = keep(this.#rates(force, 'force'));
      const change = keep(m.made(8));
      m.must(c.contact_mechanism_turn(
          this.#at, keep(this.#rates(ratesAtEnd, 'ratesAtEnd')), at, change));
      force.set(m.view(at, this.#size));
      return m.view(change, 1)[0];
    });
  }
  hold(rates, ratesAtEnd) {
    return m.during((keep) => {
      const at = keep(this.#rates(rates, 'rates'));
      m.must(c.contact_mechanism_hold(
          this.#at, keep(m.numbers(rates)),
          keep(this.#rates(ratesAtEnd, 'ratesAtEnd')), at));
      return m.view(at, this.#size).slice();
    });
  }
  get(i) {
    m.must(c.contact_mechanism_get(this.#at, i, this.#step, 0));
    return m.stepAt(this.#step);
  }
};

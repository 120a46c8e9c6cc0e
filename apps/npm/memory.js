// Numbers and texts in the memory of the module, whose exports are `c`.
export class ContactError extends Error {}

// Room for structs that are not looked into, bytes; layout.cpp compares.
export const ROOM = {solution: 512, rest: 512, step: 1024, notes: 8192};
export const STATUS = ['ok', 'out_of_range', 'not_converged', 'bad_input',
                       'run_failed', 'failure', 'out_of_seat'];

export function memoryOf(c) {
  const release = (handles) => handles.forEach(([give, at]) => give(at));
  const registry = new FinalizationRegistry(release);
  // Views, made anew where the memory has grown.
  let views;
  const heap = () => views?.bytes.buffer === c.memory.buffer ? views : views = {
    bytes: new Uint8Array(c.memory.buffer),
    words: new Int32Array(c.memory.buffer),
    numbers: new Float64Array(c.memory.buffer),
  };
  const made = (bytes) => {
    const at = c.malloc(bytes);
    if (!at) throw new ContactError('out of memory');
    heap().bytes.fill(0, at, at + bytes);
    return at;
  };
  const put = (at, values = []) => {
    heap().numbers.set(values, at / 8);
    return at;
  };
  // Values, if they are as many as C reads or writes.
  const sized = (values, count, name) => {
    if (values.length === count) return values;
    throw new ContactError(
        `${name} must have ${count} numbers, not ${values.length}`);
  };
  // The same of three, where they are given.
  const vector = (v) => v?.length ? sized(v, 3, 'a vector') : v;
  const read = (at) => {
    const {bytes} = heap();
    return new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)));
  };
  return {
    heap, made, put, read, sized, vector,
    view: (at, size) => heap().numbers.subarray(at / 8, at / 8 + size),
    word: (at) => heap().words[at / 4],
    numbers: (values) => put(made(8 * values.length + 8), values),
    vectors(...all) {
      const at = made(24 * all.length);
      all.forEach((v, i) => put(at + 24 * i, vector(v)));
      return at;
    },
    words(values) {
      const at = made(4 * values.length + 4);
      heap().words.set(values, at / 4);
      return at;
    },
    text(string) {
      const bytes = new TextEncoder().encode(string);
      const at = made(bytes.length + 1);
      heap().bytes.set(bytes, at);
      return at;
    },
    // The word of a status, unless it is a refusal or a failure.
    must(status) {
      if (status === 3 || status === 5) {
        throw new ContactError(read(c.contact_last_message()));
      }
      return STATUS[status];
    },
    // use(keep) with memory that keep(address) gives back at the end.
    during(use) {
      const all = [];
      try {
        return use((at) => (all.push(at), at));
      } finally {
        all.forEach((at) => c.free(at));
      }
    },
    // A contact_step as an object.
    stepAt: (at) => ({
      status: STATUS[heap().words[at / 4]],
      holds: heap().words[at / 4 + 1] !== 0,
      angular_velocity: Array.from(heap().numbers.subarray(at / 8 + 1, at / 8 + 4)),
      moment: Array.from(heap().numbers.subarray(at / 8 + 4, at / 8 + 7)),
    }),
    // Gives handles, each [function, address], back with their owner, or by the
    // function that this returns.
    own(owner, ...handles) {
      registry.register(owner, handles, owner);
      return () => {
        registry.unregister(owner);
        release(handles.splice(0));
      };
    },
  };
}

// libcontact in WebAssembly: joints from texts or objects, numbers out, in SI
// units and radians. Structs of the C interface are written as the bytes that
// they are; layout.cpp compares their places with the compiler's.
import {ContactError, memoryOf} from './memory.js';
import {jointOf} from './joint.js';
import {mechanismOf} from './mechanism.js';
import {quantitiesOf} from './quantities.js';

export {ContactError};

async function moduleOf(source = new URL('./contact.wasm', import.meta.url)) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof Uint8Array) return WebAssembly.compile(source);
  if (/^file:/.test(source) && globalThis.process?.versions?.node) {
    const {readFile} = await import('node:fs/promises');
    return WebAssembly.compile(await readFile(new URL(source)));
  }
  const answer = await fetch(source);
  if (!answer.ok) throw new ContactError(`${source}: ${answer.status}`);
  return WebAssembly.compile(await answer.arrayBuffer());
}

// source: bytes, a Module or an address; the file beside this one.
export async function load(source) {
  const module = await moduleOf(source);
  const imports = {};
  for (const {module: from, name} of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = () => 52;  // ENOSYS: neither files nor environment
  }
  const {exports: c} = await WebAssembly.instantiate(module, imports);
  c._initialize();
  const m = memoryOf(c);
  const quantities = quantitiesOf(c, m);
  return {
    Joint: jointOf(c, m, quantities), Mechanism: mechanismOf(c, m),
    quantities: quantities.tables, version: m.read(c.contact_version()),
  };
}

// Starts the worker of the engine while the browser reads the rest of the page,
// of which the engine's code is the most.
const engineWorker = new Worker(URL.createObjectURL(new Blob(
    [document.getElementById('engine').textContent], {type: 'text/javascript'})));

// Compiles the code, packed by gzip, in base64, while it is unpacked; by the
// time that the worker runs it is done.
async function compileEngine(packed) {
  const text = atob(packed);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
  const code = new Blob([bytes]).stream().pipeThrough(
      new DecompressionStream('gzip'));
  return WebAssembly.compileStreaming(
      new Response(code, {headers: {'Content-Type': 'application/wasm'}}));
}

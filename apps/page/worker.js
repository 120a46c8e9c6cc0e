// Runs in a worker behind the engine's own script. The first message has the
// engine's code, packed by gzip in base64; then come texts, and JSON goes out.
const unpacked = async (text) => {
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream()
      .pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
};

let engine;

onmessage = async ({data: {wasm, id, call, texts}}) => {
  engine ??= unpacked(wasm).then((wasmBinary) => Engine({wasmBinary}));
  if (wasm) return;
  const {ccall} = await engine;
  postMessage({
    id, json: ccall(`page_${call}`, 'string', texts.map(() => 'string'), texts),
  });
};

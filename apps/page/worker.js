// Runs in a worker behind the engine's own script. The first message has the
// engine's code; then come texts, and JSON goes out.
let engine;

onmessage = async ({data: {wasmBinary, id, call, texts}}) => {
  engine ??= Engine({wasmBinary});
  if (wasmBinary) return;
  const {ccall} = await engine;
  postMessage({
    id, json: ccall(`page_${call}`, 'string', texts.map(() => 'string'), texts),
  });
};

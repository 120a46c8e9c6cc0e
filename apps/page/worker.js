// Runs in a worker behind the engine's own script. The first message has the
// compiled engine; then come texts, and JSON goes out.
let engine;

onmessage = async ({data: {code, id, call, texts}}) => {
  engine ??= Engine({
    instantiateWasm(imports, use) {
      WebAssembly.instantiate(code, imports).then(use);
      return {};
    },
  });
  const {ccall} = await engine;
  if (code) return;
  postMessage({
    id, json: ccall(`page_${call}`, 'string', texts.map(() => 'string'), texts),
  });
};

// So that the page hears of it.
addEventListener('unhandledrejection', ({reason}) => {
  throw reason;
});

// Runs in a worker behind the engine's own script: texts in, JSON out.
const engine = Engine();

onmessage = async ({data: {id, call, texts}}) => {
  const {ccall} = await engine;
  postMessage({
    id, json: ccall(`page_${call}`, 'string', texts.map(() => 'string'), texts),
  });
};

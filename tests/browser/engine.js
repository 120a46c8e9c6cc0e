// The engine of the page in node: ask(call, texts...) is what it answers.
'use strict';
const fs = require('fs');
const path = require('path');

const file = path.resolve(process.env.CONTACT_ENGINE);
const engine = require(file)(
    {wasmBinary: fs.readFileSync(file.replace(/js$/, 'wasm'))});

module.exports = async (call, ...texts) => JSON.parse((await engine).ccall(
    `page_${call}`, 'string', texts.map(() => 'string'), texts));

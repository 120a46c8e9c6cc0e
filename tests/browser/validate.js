// What Khronos' validator says of glTF files, and which bodies move in them:
// node validate.js FILE...
'use strict';
const fs = require('fs');
const validator = require('gltf-validator');

(async () => {
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(
        new Uint8Array(fs.readFileSync(file)));
    console.log(`${file}: ${report.issues.numErrors} errors, ` +
        `${report.issues.numWarnings} warnings`);
    for (const message of report.issues.messages) {
      console.log(`  ${message.severity} ${message.code} ${message.pointer}: ` +
          message.message);
    }
    if (report.issues.numErrors + report.issues.numWarnings > 0) {
      process.exitCode = 1;
    }
  }
})();

// A picture of the page to calculate on, for the README:
//   node plots/page.js build-wasm/calculator.html plots/page.jpg
// Needs Chromium and `npm ci --prefix tests/browser`.
'use strict';
const {withPage} = require('../tests/browser/chromium.js');
const [, , file, picture] = process.argv;

const hash = '#kind=ball&pair=steel_ptfe_liner.toml&wall=layer';
const viewport = {width: 1600, height: 960};
withPage(file, {hash, viewport}, async (page) => {
  await page.waitForFunction(
      () => performance.getEntriesByName('curves').length > 0);
  await page.screenshot({path: picture, quality: 82});  // of a .jpg
});

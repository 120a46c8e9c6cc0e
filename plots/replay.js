// A picture of a page of hinge-separation --replay, for the README:
//   node plots/replay.js PAGE.html PICTURE.jpg TIME
// Needs Chromium and `npm ci --prefix tests/browser`.
'use strict';
const {withPage} = require('../tests/browser/chromium.js');
const [, , file, picture, time] = process.argv;

withPage(file, {viewport: {width: 1240, height: 720}}, async (page) => {
  await page.evaluate((t) => {
    replay.go(t);
    replay.update();
  }, Number(time));
  await page.waitForTimeout(500);
  await page.screenshot({path: picture, quality: 86});  // of a .jpg
});

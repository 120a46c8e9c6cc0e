// Pictures of a page of hinge-separation --replay for a film, which film.py makes:
//   node plots/film.js PAGE.html FOLDER FROM TO COUNT
// Needs Chromium and `npm ci --prefix tests/browser`.
'use strict';
const fs = require('fs');
const path = require('path');
const {withPage} = require('../tests/browser/chromium.js');
const [, , file, folder, from, to, count] = process.argv;

withPage(file, {viewport: {width: 1240, height: 720}}, async (page) => {
  for (let i = 0; i < Number(count); ++i) {
    const time = Number(from) + (to - from) * i / (count - 1);
    const png = await page.evaluate(async (t) => {
      replay.go(t);
      replay.update();
      const blob = await replay.snapshot();
      return await new Promise((done) => {
        const reader = new FileReader();
        reader.onload = () => done(reader.result.replace(/^.*,/, ''));
        reader.readAsDataURL(blob);
      });
    }, time);
    fs.writeFileSync(path.join(folder, `${String(i).padStart(3, '0')}.png`),
                     Buffer.from(png, 'base64'));
  }
});

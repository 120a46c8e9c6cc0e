// Chromium without a window, for pages from files: what every test of a page
// and scripts that draw one stand on.
'use strict';
const {pathToFileURL} = require('url');
const {chromium} = require('playwright-core');

const settings = [
  '--headless=new', '--no-sandbox', '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader', '--no-first-run',
  '--disable-background-networking', '--disable-component-update',
  '--disable-sync', '--disable-quic',
];

// One for all pages of a program: it takes longer to start than most of them.
// It goes when no page has been open for a moment.
let starting;
let pages = 0;
let leaving;
function browser() {
  clearTimeout(leaving);
  ++pages;
  return starting ??= chromium.launch({
    executablePath: '/usr/bin/chromium', headless: false, args: settings,
  });
}
function leave() {
  if (--pages > 0) return;
  leaving = setTimeout(async () => {
    const gone = starting;
    starting = undefined;
    await (await gone).close();
  }, 200);
}

// Calls use(page, said) with a page on which `file` is open and ready, a replay
// at its start and not playing, in a profile of its own; `said` has everything
// that a good page does not do: console messages, errors, requests for anything
// but itself and parts of itself (blobs). `hash` follows in the address.
// `prepare` sees the page before.
async function withPage(file, {hash = '', ...options}, use,
                        prepare = async () => {}) {
  const context = await (await browser()).newContext(
      {viewport: {width: 1280, height: 800}, ...options});
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(120e3);  // machines of tests are busy
    const {href: url} = pathToFileURL(file);
    const said = [];
    page.on('console', (message) => said.push(message.text()));
    page.on('pageerror', (error) => said.push(error.message));
    page.on('dialog', (dialog) => said.push(dialog.message()));
    page.on('request', (request) => {
      if (![url, url + hash].includes(request.url()) &&
          !request.url().startsWith('blob:')) said.push(request.url().slice(0, 200));
    });
    await prepare(page);
    await page.goto(url + hash);
    // A report of a study has no data.
    await page.evaluate(() => document.getElementById('data') &&
        replay.ready.then(() => replay.go(-Infinity)));
    return await use(page, said);
  } finally {
    await context.close();
    leave();
  }
}

module.exports = {withPage};

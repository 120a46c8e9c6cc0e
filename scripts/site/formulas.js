// Formulas of pages: node scripts/site/formulas.js FOLDER_OR_PAGE... parses all
// with KaTeX, and prints the places of those that KaTeX or GitHub reject.
const fs = require('node:fs');
const path = require('node:path');
const katex = require('/usr/share/javascript/katex/katex.min.js');

// GitHub takes backslashes before punctuation out of a formula in a line, reads
// * and an _ behind punctuation as emphasis, and needs no space beside the $.
const reserved = /\\[^A-Za-z]|\*|[^\w\\]_|^\s|\s$|\]\(/;

function pages(place) {
  if (!fs.statSync(place).isDirectory()) return [place];
  return fs.readdirSync(place).sort().flatMap((name) => {
    const file = path.join(place, name);
    return fs.statSync(file).isDirectory() || /\.md$/.test(name) ? pages(file) : [];
  });
}

/// Formulas of a page: text, line, and whether in a block of their own.
function formulas(text) {
  const found = [];
  const blank = (part) => part.replace(/[^\n]/g, ' ');
  const line = (at) => text.slice(0, at).split('\n').length;
  const prose = text.replace(/^```(.*)\n([^]*?)^```/gm, (all, kind, inside, at) => {
    if (kind === 'math') found.push({tex: inside, line: line(at), block: true});
    return blank(all);
  }).replace(/`[^`]*`/g, blank);
  for (const match of prose.matchAll(/\$([^$]*)\$/g)) {
    found.push({tex: match[1], line: line(match.index), block: false});
  }
  return found;
}

let errors = 0;
let count = 0;
for (const page of process.argv.slice(2).flatMap(pages)) {
  for (const {tex, line, block} of formulas(fs.readFileSync(page, 'utf8'))) {
    ++count;
    try {
      if (!block && reserved.test(tex)) throw new Error('GitHub needs a block for this');
      katex.renderToString(tex, {displayMode: block, throwOnError: true, strict: 'error'});
    } catch (error) {
      ++errors;
      console.log(`${page}:${line}: ${tex.trim()}: ${error.message}`);
    }
  }
}
console.log(`${count} formulas, ${errors} with errors`);
process.exit(errors || !count ? 1 : 0);

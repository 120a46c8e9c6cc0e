// The picture with what is written over it as a file, and one for each moment
// of a film.

function drawText(context, text, x, y, colour) {
  context.fillStyle = colour;
  context.fillText(text, x, y);
}

function drawLabels(context, style) {
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  for (const {text, x, y, colour} of labels.placed) {
    const width = context.measureText(text).width + 10;
    context.fillStyle = style('--label');
    context.fillRect(x - width / 2, y - 8, width, 16);
    if (colour) {
      context.fillStyle = colour;
      context.fillRect(x - width / 2 - 4, y - 8, 4, 16);
    }
    drawText(context, text, x, y, style('--text'));
  }
}

function drawCompass(context, style) {
  const y = picture.height - 45;
  compass.ends().forEach((end, i) => {
    const [letter, colour] = compass.axes[i];
    context.strokeStyle = colour;
    context.beginPath();
    context.moveTo(45, y);
    context.lineTo(45 + end[0], y + end[1]);
    context.stroke();
    drawText(context, letter, 45 + 1.35 * end[0], y + 1.35 * end[1], colour);
  });
  const {width, text} = compass.scale();
  context.fillStyle = style('--text');
  const x = picture.width - 7 - width;
  context.fillRect(x, picture.height - 14, width, 2);
  drawText(context, text, x + width / 2, picture.height - 23, style('--text'));
}

function drawContact(context, style) {
  const x = picture.width - contactSize - 2;
  context.font = '12px sans-serif';
  [at('hinge').selectedOptions[0].textContent,
   ...at('contact_text').textContent.split('\n')].forEach((line, i) => drawText(
      context, line, x, i === 0 ? 20 : contactSize - 26 + 15 * i,
      style('--text')));
}

// The picture as it is now, with the name of the case and the time.
function snapshot() {
  const canvas = document.createElement('canvas');
  const view = at('view');
  canvas.width = view.width;
  canvas.height = view.height;
  const context = canvas.getContext('2d');
  const page = getComputedStyle(document.documentElement);
  const style = (name) => page.getPropertyValue(name).trim();
  context.fillStyle = style('--surface');
  context.fillRect(0, 0, canvas.width, canvas.height);
  picture.draw();  // what WebGL has drawn is gone with this turn
  context.drawImage(view, 0, 0);
  context.scale(view.width / picture.width, view.height / picture.height);
  context.font = '12px sans-serif';
  drawLabels(context, style);
  drawCompass(context, style);
  context.textAlign = 'left';
  context.font = '14px sans-serif';
  drawText(context, document.querySelector('h1').textContent, 10, 16,
           style('--text'));
  drawText(context, seconds(now), 10, 36, style('--text'));
  if (picture.contact.shown) drawContact(context, style);
  return new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
}

function save(blob, ending) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = document.title.replace(/[^\w-]+/g, '_') + ending;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60e3);
}

const savePicture = async () => save(
    await snapshot(), `_${now.toFixed(3).replace('.', '_')}s.png`);

// Times of a film of 25 pictures a second, at the speed of the page. More than
// that no browser has memory for.
function filmTimes() {
  const most = 3000;
  const lasts = take.end - take.start;
  const step = Math.max(Number(at('speed').value) / 25, lasts / most);
  return Array.from({length: Math.floor(lasts / step + 1e-9) + 1},
                    (_, i) => take.start + i * step);
}

// A second call ends the first one, which saves what it has.
let filming = false;
async function saveFilm() {
  if (filming) {
    filming = false;
    return;
  }
  play(false);
  filming = true;
  const button = at('save_film');
  const text = button.textContent;
  const files = [];
  for (const time of filmTimes()) {
    if (!filming) break;
    now = time;
    update(performance.now());
    const bytesOf = await (await snapshot()).arrayBuffer();
    files.push([`frame_${String(files.length).padStart(4, '0')}.png`,
                new Uint8Array(bytesOf)]);
    button.textContent = `${files.length} frames`;
  }
  filming = false;
  button.textContent = text;
  save(new Blob(zipped(files), {type: 'application/zip'}), '_frames.zip');
}

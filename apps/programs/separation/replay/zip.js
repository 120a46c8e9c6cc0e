// Files in one: a ZIP archive that leaves them as they are.

// The check sum (CRC-32) that ZIP asks for.
function checkSum(file) {
  let sum = ~0;
  for (const byte of file) {
    sum ^= byte;
    for (let bit = 0; bit < 8; ++bit) sum = sum >>> 1 ^ (sum & 1 && 0xedb88320);
  }
  return ~sum >>> 0;
}

// Numbers of 2 and of 4 bytes, the lowest first.
const little = (size) => (number) =>
    Array.from({length: size}, (_, i) => number >>> 8 * i & 255);
const [short, long] = [little(2), little(4)];

// Both records of a file share these bytes. All files are of 1980-01-01, so that
// the same ones make the same archive.
const fileHead = (name, file) => [
  ...short(20), ...short(0), ...short(0), ...short(0), ...short(33),
  ...long(checkSum(file)), ...long(file.length), ...long(file.length),
  ...short(name.length), ...short(0)];

/** @param files  names of plain letters, and bytes */
function zipped(files) {
  const parts = [];
  const directory = [];
  let at = 0;
  for (const [text, file] of files) {
    const name = [...text].map((letter) => letter.charCodeAt(0));
    const head = fileHead(name, file);
    directory.push(...long(0x02014b50), ...short(20), ...head, ...short(0),
                   ...short(0), ...short(0), ...long(0), ...long(at), ...name);
    parts.push(
        Uint8Array.from([...long(0x04034b50), ...head, ...name]), file);
    at += 30 + name.length + file.length;
  }
  const count = short(parts.length / 2);
  parts.push(Uint8Array.from([
    ...directory, ...long(0x06054b50), ...short(0), ...short(0), ...count,
    ...count, ...long(directory.length), ...long(at), ...short(0)]));
  return parts;
}

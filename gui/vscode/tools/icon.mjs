// Draws images/icon.png: Pendant's arm, white on blue, with the numbers of the window's glyph (robot.svg).
import { writeFileSync } from 'node:fs';
import { deflateSync, crc32 } from 'node:zlib';

const size = 256;
const samples = 4; // in each direction within a pixel
const ground = [0x2f, 0x5d, 0x8c];
const glyph = 0.8; // share of the picture that the glyph's 24 units take

const lines = [
  [5, 21, 15, 21],
  [10, 21, 10, 14],
  [10, 14, 16, 8],
  [16, 8, 20, 11],
];
const joints = [
  [10, 14],
  [16, 8],
];

function toLine(x, y, [x1, y1, x2, y2]) {
  const dx = x2 - x1;
  const dy = y2 - y1;
  const along = Math.min(1, Math.max(0, ((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(x - x1 - along * dx, y - y1 - along * dy);
}

function inArm(x, y) {
  return lines.some((each) => toLine(x, y, each) <= 0.9) || joints.some(([jx, jy]) => Math.hypot(x - jx, y - jy) <= 2);
}

// x and y from 0 to 1.
function inGround(x, y) {
  const radius = 1 / 6;
  const dx = Math.max(radius - x, x - (1 - radius), 0);
  const dy = Math.max(radius - y, y - (1 - radius), 0);
  return Math.hypot(dx, dy) <= radius;
}

const rows = [];
for (let row = 0; row < size; row++) {
  const bytes = Buffer.alloc(1 + 4 * size);
  for (let column = 0; column < size; column++) {
    let covered = 0;
    let white = 0;
    for (let i = 0; i < samples * samples; i++) {
      const x = (column + ((i % samples) + 0.5) / samples) / size;
      const y = (row + (Math.floor(i / samples) + 0.5) / samples) / size;
      if (inGround(x, y)) {
        covered++;
        white += inArm(((x - 0.1) / glyph) * 24, ((y - 0.08) / glyph) * 24) ? 1 : 0;
      }
    }
    const share = covered === 0 ? 0 : white / covered;
    for (let part = 0; part < 3; part++) {
      bytes[1 + 4 * column + part] = Math.round(ground[part] + share * (255 - ground[part]));
    }
    bytes[1 + 4 * column + 3] = Math.round((255 * covered) / (samples * samples));
  }
  rows.push(bytes);
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const whole = Buffer.alloc(body.length + 8);
  whole.writeUInt32BE(data.length, 0);
  body.copy(whole, 4);
  whole.writeUInt32BE(crc32(body), body.length + 4);
  return whole;
}

const header = Buffer.alloc(13);
header.writeUInt32BE(size, 0);
header.writeUInt32BE(size, 4);
header.set([8, 6, 0, 0, 0], 8); // 8 bits, with alpha
writeFileSync(
  new URL('../images/icon.png', import.meta.url),
  Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(Buffer.concat(rows), { level: 9 })),
    chunk('IEND', Buffer.alloc(0)),
  ]),
);

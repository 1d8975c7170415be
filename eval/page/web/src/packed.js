// Columns of numbers as eval/page/packed.hpp packs them: zigzag LEB128 steps of a unit, deflated, in base64.

const MISSING = -(2 ** 31);

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** Reads numbers one after the other. They may exceed 32 bits, so no bit operators on the whole. */
class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }
  next() {
    let value = 0;
    let scale = 1;
    for (;;) {
      if (this.at >= this.bytes.length) throw new Error('the packed columns are cut off');
      const byte = this.bytes[this.at++];
      value += (byte & 0x7f) * scale;
      if (byte < 0x80) break;
      scale *= 128;
    }
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }
}

/** The columns of one pack by name, each a Float64Array; missing numbers are NaN. */
export async function unpack(base64, heads) {
  const reader = new Reader(await inflate(bytesOf(base64)));
  const columns = {};
  for (const head of heads) {
    const values = new Float64Array(head.count);
    let steps = 0;
    for (let i = 0; i < head.count; ++i) {
      steps = head.difference ? steps + reader.next() : reader.next();
      values[i] = steps === MISSING ? NaN : steps * head.unit;
    }
    columns[head.name] = values;
  }
  return columns;
}

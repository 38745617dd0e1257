// Pictures as an animated GIF (GIF89a): one table of at most 255 colours for the whole film, and of each picture only
// the rectangle that changed, with what stays as it is transparent.

const kClear = 255;  // the transparent entry

/** Bytes that grow. */
class Bytes {
  data = new Uint8Array(1 << 16);
  length = 0;
  private room(more: number): void {
    if (this.length + more <= this.data.length) return;
    const larger = new Uint8Array(Math.max(2 * this.data.length, this.length + more));
    larger.set(this.data);
    this.data = larger;
  }
  add(...bytes: number[]): void { this.put(bytes); }
  put(bytes: ArrayLike<number>): void {
    this.room(bytes.length);
    this.data.set(bytes, this.length);
    this.length += bytes.length;
  }
  word(x: number): void { this.add(x & 255, x >> 8 & 255); }
  text(s: string): void { this.put([...s].map(c => c.charCodeAt(0))); }
  done(): Uint8Array { return this.data.slice(0, this.length); }
}

/** Colours with five bits a channel; what falls into one of these boxes gets one colour of the table. */
const boxOf = (r: number, g: number, b: number): number => r >> 3 << 10 | g >> 3 << 5 | b >> 3;

/** The colours of a film: counted in some pictures, then cut at the median until there are 255 groups. */
export class ColourTable {
  private readonly count = new Float64Array(32768);
  private readonly sum = [0, 1, 2].map(() => new Float64Array(32768));
  readonly colours: [number, number, number][] = [];
  private readonly nearest = new Int16Array(32768).fill(-1);

  look(pixels: Uint8ClampedArray): void {
    for (let i = 0; i < pixels.length; i += 4) {
      const box = boxOf(pixels[i], pixels[i + 1], pixels[i + 2]);
      ++this.count[box];
      for (let k = 0; k < 3; ++k) this.sum[k][box] += pixels[i + k];
    }
  }

  close(): void {
    const all: number[] = [];
    for (let box = 0; box < 32768; ++box) if (this.count[box]) all.push(box);
    const mean = (box: number, k: number): number => this.sum[k][box] / this.count[box];
    // A small body must not lose its colour to a large floor: a group counts by the root of its pixels.
    const weight = (box: number): number => Math.sqrt(this.count[box]);
    const widest = (group: number[]): [number, number] => {
      let best = 0, channel = 0;
      for (let k = 0; k < 3; ++k) {
        let low = 256, high = -1;
        for (const box of group) { low = Math.min(low, mean(box, k)); high = Math.max(high, mean(box, k)); }
        if (high - low > best) { best = high - low; channel = k; }
      }
      return [best, channel];
    };
    const sized = (group: number[]): {group: number[]; size: number; channel: number} => {
      const [width, channel] = widest(group);
      return {group, channel, size: width * Math.sqrt(group.reduce((s, box) => s + weight(box), 0))};
    };
    const groups = [sized(all)];
    while (groups.length < kClear) {
      let largest = 0;
      groups.forEach((g, i) => { if (g.size > groups[largest].size) largest = i; });
      const {group, channel, size} = groups[largest];
      if (!(size > 0)) break;
      group.sort((a, b) => mean(a, channel) - mean(b, channel));
      const half = group.reduce((s, box) => s + weight(box), 0) / 2;
      let cut = 1;
      for (let s = weight(group[0]); cut < group.length - 1 && s < half; ++cut) s += weight(group[cut]);
      groups.splice(largest, 1, sized(group.slice(0, cut)), sized(group.slice(cut)));
    }
    for (const {group} of groups) {
      const n = group.reduce((s, box) => s + this.count[box], 0) || 1;
      this.colours.push([0, 1, 2].map(k => Math.round(group.reduce((s, box) => s + this.sum[k][box], 0) / n)) as [number, number, number]);
    }
  }

  indexOf(r: number, g: number, b: number): number {
    const box = boxOf(r, g, b);
    if (this.nearest[box] >= 0) return this.nearest[box];
    let best = 0, least = Infinity;
    this.colours.forEach(([x, y, z], i) => {
      const d = 2 * (x - r) ** 2 + 4 * (y - g) ** 2 + (z - b) ** 2;  // the eye sees green best
      if (d < least) { least = d; best = i; }
    });
    return this.nearest[box] = best;
  }
}

/** Lempel-Ziv-Welch with codes of 9 to 12 bits, in blocks of 255 bytes. */
function compressed(pixels: Uint8Array, out: Bytes): void {
  const kReset = 256, kEnd = 257;
  out.add(8);
  let block: number[] = [], bits = 0, held = 0, width = 9, next = 258;
  let known = new Map<number, number>();
  const flush = (): void => { if (block.length) { out.add(block.length); out.put(block); block = []; } };
  const code = (c: number): void => {
    held |= c << bits;
    bits += width;
    while (bits >= 8) {
      block.push(held & 255);
      held >>>= 8;
      bits -= 8;
      if (block.length === 255) flush();
    }
  };
  code(kReset);
  let prefix = pixels[0];
  for (let i = 1; i < pixels.length; ++i) {
    const key = prefix << 8 | pixels[i], found = known.get(key);
    if (found !== undefined) { prefix = found; continue; }
    code(prefix);
    if (next === 4096) {
      code(kReset);
      known = new Map();
      next = 258;
      width = 9;
    } else {
      if (next === 1 << width) ++width;
      known.set(key, next++);
    }
    prefix = pixels[i];
  }
  code(prefix);
  code(kEnd);
  if (bits) block.push(held & 255);
  flush();
  out.add(0);
}

export class Gif {
  private readonly out = new Bytes();
  private before: Uint8Array | null = null;
  private written = 0;  // hundredths of a second

  constructor(private readonly width: number, private readonly height: number, private readonly table: ColourTable) {
    const {out} = this;
    out.text("GIF89a");
    out.word(width);
    out.word(height);
    out.add(0xf7, 0, 0);  // a table of 256 colours
    for (let i = 0; i < 256; ++i) out.put(table.colours[i] ?? [0, 0, 0]);
    out.add(0x21, 0xff, 11);
    out.text("NETSCAPE2.0");
    out.add(3, 1, 0, 0, 0);  // again and again
  }

  /** Shows a picture until `end`, counted from the beginning of the film [s]. */
  add(pixels: Uint8ClampedArray, end: number): void {
    const {out, width, height, table, before} = this, now = new Uint8Array(width * height);
    for (let i = 0; i < now.length; ++i) now[i] = table.indexOf(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2]);
    let x0 = 0, y0 = 0, x1 = width - 1, y1 = height - 1;
    if (before) {
      x0 = width; y0 = height; x1 = y1 = -1;
      for (let y = 0, i = 0; y < height; ++y) for (let x = 0; x < width; ++x, ++i) {
        if (now[i] === before[i]) continue;
        x0 = Math.min(x0, x); x1 = Math.max(x1, x); y0 = Math.min(y0, y); y1 = y;
      }
      if (x1 < 0) x0 = y0 = x1 = y1 = 0;
    }
    const part = new Uint8Array((x1 - x0 + 1) * (y1 - y0 + 1));
    for (let y = y0, k = 0; y <= y1; ++y) for (let x = x0; x <= x1; ++x, ++k) {
      const i = y * width + x;
      part[k] = before && before[i] === now[i] ? kClear : now[i];
    }
    const until = Math.round(100 * end), shown = Math.max(2, until - this.written);
    this.written += shown;
    out.add(0x21, 0xf9, 4, before ? 5 : 4);  // what lies below stays; one entry is transparent
    out.word(shown);
    out.add(kClear, 0, 0x2c);
    for (const x of [x0, y0, x1 - x0 + 1, y1 - y0 + 1]) out.word(x);
    out.add(0);
    compressed(part, out);
    this.before = now;
  }

  done(): Uint8Array {
    this.out.add(0x3b);
    return this.out.done();
  }
}

// A film as WebM: pictures coded by the browser (WebCodecs, VP9 or VP8), in the few elements of Matroska that players
// need: head, length, one track, clusters of blocks.

type Part = Uint8Array | number[];

const joined = (parts: Part[]): Uint8Array => {
  const out = new Uint8Array(parts.reduce((n, p) => n + p.length, 0));
  let at = 0;
  for (const p of parts) { out.set(p, at); at += p.length; }
  return out;
};

/** An element: number, size in eight bytes, content. */
function tag(id: number, ...content: Part[]): Uint8Array {
  const size = content.reduce((n, p) => n + p.length, 0), head: number[] = [];
  for (let shift = 24; shift >= 0; shift -= 8) if (id >>> shift) head.push(id >>> shift & 255);
  head.push(1, 0, 0, Math.floor(size / 2 ** 32), size >>> 24 & 255, size >>> 16 & 255, size >>> 8 & 255, size & 255);
  return joined([head, ...content]);
}
const whole = (id: number, x: number): Uint8Array => tag(id, [x >>> 24 & 255, x >>> 16 & 255, x >>> 8 & 255, x & 255]);
const text = (id: number, s: string): Uint8Array => tag(id, [...s].map(c => c.charCodeAt(0)));
function real(id: number, x: number): Uint8Array {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, x);
  return tag(id, bytes);
}

interface Block { time: number; key: boolean; data: Uint8Array }  // time [ms]

function file(blocks: Block[], codec: string, width: number, height: number, length: number): Uint8Array {
  const clusters: Uint8Array[] = [];
  let start = 0, group: Uint8Array[] = [];
  const close = (): void => { if (group.length) clusters.push(tag(0x1f43b675, whole(0xe7, start), ...group)); group = []; };
  for (const b of blocks) {
    if (b.key || b.time - start > 30000) { close(); start = b.time; }
    const since = b.time - start;
    group.push(tag(0xa3, [0x81, since >> 8 & 255, since & 255, b.key ? 0x80 : 0], b.data));
  }
  close();
  return joined([
    tag(0x1a45dfa3, whole(0x4286, 1), whole(0x42f7, 1), whole(0x42f2, 4), whole(0x42f3, 8), text(0x4282, "webm"),
      whole(0x4287, 4), whole(0x4285, 2)),
    tag(0x18538067,
      tag(0x1549a966, whole(0x2ad7b1, 1000000), text(0x4d80, "dynamY"), text(0x5741, "dynamY"), real(0x4489, length)),
      tag(0x1654ae6b, tag(0xae, whole(0xd7, 1), whole(0x73c5, 1), whole(0x83, 1), text(0x86, codec),
        tag(0xe0, whole(0xb0, width), whole(0xba, height)))),
      ...clusters)]);
}

/** Whether the browser can code films. */
export const codesFilms = (): boolean => typeof VideoEncoder !== "undefined";

/** Takes `count` pictures in turn; `fps`: of the film. */
export async function webm(count: number, fps: number, width: number, height: number,
                           picture: (i: number) => Promise<HTMLCanvasElement>): Promise<Uint8Array> {
  const blocks: Block[] = [];
  let wrong: Error | null = null;
  const encoder = new VideoEncoder({
    output: chunk => {
      const data = new Uint8Array(chunk.byteLength);
      chunk.copyTo(data);
      blocks.push({time: Math.round(chunk.timestamp / 1000), key: chunk.type === "key", data});
    },
    error: e => { wrong = e; }});
  let codec = "V_VP9";
  const settings: VideoEncoderConfig = {codec: "vp09.00.41.08", width, height, framerate: fps, latencyMode: "quality",
    bitrate: Math.max(4e5, 0.12 * width * height * fps)};
  if (!(await VideoEncoder.isConfigSupported(settings)).supported) { settings.codec = "vp8"; codec = "V_VP8"; }
  encoder.configure(settings);
  for (let i = 0; i < count; ++i) {
    const frame = new VideoFrame(await picture(i), {timestamp: Math.round(1e6 * i / fps), duration: Math.round(1e6 / fps)});
    encoder.encode(frame, {keyFrame: i % Math.max(1, Math.round(2 * fps)) === 0});
    frame.close();
    while (encoder.encodeQueueSize > 8) await new Promise(done => setTimeout(done, 5));
    if (wrong) throw wrong as Error;
  }
  await encoder.flush();
  encoder.close();
  return file(blocks, codec, width, height, 1000 * count / fps);
}

// The run as a film in a file: pictures of the stage at equal steps of time, as GIF, WebM or PNG. The page saves one by
// its button; `dynamy view --video` calls the same functions in a browser without a window.
import {ColourTable, Gif} from "./gif";
import type {Replay} from "./replay";
import {kStates, mixed, theme} from "./theme";
import {codesFilms, webm} from "./webm";

export interface FilmChoice {
  from: number; to: number;  // of the run [s]
  slower: number;            // how many times slower than the mechanism
  fps: number;
  width?: number; height?: number;  // [px], even; else those of the stage
}

const kFont = "system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";

export class FilmFile {
  readonly count: number;
  private readonly picture: HTMLCanvasElement;
  private readonly ctx: CanvasRenderingContext2D;

  constructor(private readonly replay: Replay, private readonly choice: FilmChoice) {
    this.count = Math.max(1, Math.round((choice.to - choice.from) * choice.slower * choice.fps));
    const {width, height} = replay.comparison.picture(choice.from), even = (x: number): number => Math.max(2, 2 * Math.round(x / 2));
    this.picture = document.createElement("canvas");
    this.picture.width = even(choice.width ?? width);
    this.picture.height = even(choice.height ?? height);
    this.ctx = this.picture.getContext("2d", {willReadFrequently: true}) as CanvasRenderingContext2D;
  }

  /** The i-th picture; the next call paints over it. */
  paint(i: number): HTMLCanvasElement {
    const {ctx, picture, choice, replay} = this, {width, height} = picture;
    const t = Math.min(choice.from + i / (choice.slower * choice.fps), replay.end);
    ctx.fillStyle = theme.paper;
    ctx.fillRect(0, 0, width, height);
    // equal scales along both sides, whatever the sizes are: the rest stays paper
    const seen = replay.comparison.picture(t), scale = Math.min(width / seen.width, height / seen.height);
    const [w, h] = [seen.width * scale, seen.height * scale];
    ctx.drawImage(seen, (width - w) / 2, (height - h) / 2, w, h);
    this.caption(t);
    return picture;
  }

  /** Time, and the colours of the forces. */
  private caption(t: number): void {
    const {ctx, picture, replay} = this, size = Math.max(11, Math.round(picture.height / 40));
    const span = replay.end - replay.begin, digits = Math.max(0, Math.min(6, 3 - Math.floor(Math.log10(span || 1))));
    ctx.font = `${size}px ${kFont}`;
    ctx.textBaseline = "top";
    ctx.textAlign = "left";
    ctx.fillStyle = theme.soft;
    ctx.fillText(`${t.toFixed(digits)} s`, size, size);
    const {names, stacked} = replay.comparison;
    names.forEach((name, i) => {
      const share = (i + 1) / names.length;  // of the film that ends with this picture
      ctx.fillText(name, size + (stacked ? 0 : i * picture.width / names.length), (stacked ? share : 1) * picture.height - 2 * size);
    });
    if (!replay.stage.show.contacts || !replay.film.contactCount) return;
    ctx.textAlign = "right";
    let x = picture.width - size;
    for (const state of kStates.slice(1, 4).reverse()) {
      ctx.fillStyle = theme.soft;
      ctx.fillText(state.name, x, size);
      x -= ctx.measureText(state.name).width + 0.5 * size;
      ctx.fillStyle = theme.dark ? mixed(state.colour, 0.2) : state.colour;
      ctx.fillRect(x - size, 1.45 * size, size, 0.22 * size);
      x -= 2 * size;
    }
  }

  private pixels(i: number): Uint8ClampedArray {
    this.paint(i);
    return this.ctx.getImageData(0, 0, this.picture.width, this.picture.height).data;
  }

  /** `told` is called after each picture with the share that is done. */
  async gif(told: (share: number) => Promise<void>): Promise<Uint8Array> {
    const table = new ColourTable(), looks = Math.min(this.count, 12);
    for (let k = 0; k < looks; ++k) table.look(this.pixels(Math.floor(k * this.count / looks)));
    table.close();
    const out = new Gif(this.picture.width, this.picture.height, table);
    for (let i = 0; i < this.count; ++i) {
      out.add(this.pixels(i), (i + 1) / this.choice.fps);
      await told((i + 1) / this.count);
    }
    return out.done();
  }

  async webm(told: (share: number) => Promise<void>): Promise<Uint8Array> {
    return webm(this.count, this.choice.fps, this.picture.width, this.picture.height, async i => {
      await told((i + 1) / this.count);
      return this.paint(i);
    });
  }

  png(i: number): string { return this.paint(i).toDataURL("image/png").split(",")[1]; }
}

const base64 = async (bytes: Uint8Array): Promise<string> => {
  const url = await new Promise<string>(done => {
    const reader = new FileReader();
    reader.onload = () => done(String(reader.result));
    reader.readAsDataURL(new Blob([bytes as BlobPart]));
  });
  return url.slice(url.indexOf(",") + 1);
};

/** What a program that drives the page calls: begin, then take(i) for pictures or file(kind) for a film. */
export class FilmStudio {
  private film: FilmFile | null = null;
  share = 0;

  constructor(private readonly replay: Replay) {}

  /** Gives the stage its size and returns the number of pictures. */
  begin(choice: Partial<FilmChoice> & {fps: number}): number {
    const {stage, comparison} = this.replay;
    if (choice.width && choice.height) {
      const box = document.getElementById("stages") as HTMLElement;
      // the rules for small windows do not hold for films: pictures side by side, or in tall films one above the other
      box.style.cssText = `position:fixed;left:0;top:0;z-index:9;width:${choice.width}px;height:${choice.height}px;` +
        `min-height:0;flex-direction:${choice.height > choice.width ? "column" : "row"}`;
      (document.getElementById("beside") as HTMLElement).style.border = "none";  // the picture has its own line
      comparison.resize();
      stage.fit();
    }
    const {begin, end} = this.replay;
    const from = Math.max(choice.from ?? begin, begin), to = Math.min(choice.to ?? end, end);
    const slower = choice.slower ?? 1 / Number((document.getElementById("speed") as HTMLSelectElement).value);
    this.film = new FilmFile(this.replay, {...choice, from, to, slower});
    return this.film.count;
  }

  take(i: number): string { return this.film?.png(i) ?? ""; }

  async file(kind: "gif" | "webm"): Promise<string> {
    if (!this.film) return "";
    if (kind === "webm" && !codesFilms()) throw new Error("this browser codes no films: take a GIF");
    const told = async (share: number): Promise<void> => {
      this.share = share;
      await new Promise(done => setTimeout(done, 0));  // others may ask how far it is
    };
    return base64(await this.film[kind](told));
  }
}

/** Saves the whole run as it is seen now, at the speed that is chosen: the button of the page. */
export async function saveFilm(replay: Replay, speed: number, button: HTMLElement): Promise<void> {
  const label = button.textContent;
  const told = async (share: number): Promise<void> => {
    button.textContent = `${Math.round(100 * share)} %`;
    await new Promise(done => setTimeout(done, 0));
  };
  const film = new FilmFile(replay, {from: replay.begin, to: replay.end, slower: 1 / speed, fps: 25});
  const kind = codesFilms() ? "webm" : "gif";
  try {
    const bytes = await film[kind](told), a = document.createElement("a");
    a.href = URL.createObjectURL(new Blob([bytes as BlobPart], {type: kind === "webm" ? "video/webm" : "image/gif"}));
    a.download = `${replay.data.title}.${kind}`;
    a.click();
  } finally {
    button.textContent = label;
    replay.draw();
  }
}

// Starts the page: a replay from the data in it, or a live run from what the program sends.
import {eventsOf, ledgerOf, RecordedFilm, sceneOf, signalsOf, type PageData, type Scene, type Signal} from "./data";
import {Live, LiveFeed} from "./live";
import {OtherRun} from "./other_run";
import {Replay} from "./replay";

const byId = (id: string): HTMLElement => document.getElementById(id) as HTMLElement;

async function start(): Promise<void> {
  const data = JSON.parse(byId("data").textContent ?? "") as PageData, address = new URLSearchParams(location.hash.slice(1));
  const [scene, signals] = await Promise.all([sceneOf(data), signalsOf(data)]);
  const replay = document.body.dataset.live ? await startLive(data, scene, signals, address)
    : new Replay(data, scene, await RecordedFilm.from(data.frames), signals, await eventsOf(data), await ledgerOf(data), address);
  const other = document.getElementById("other");
  if (other) {
    replay.layOver(await OtherRun.from(JSON.parse(other.textContent ?? "") as PageData, ""));
    if (other.dataset.beside) replay.setBeside(true);
  }
  document.body.classList.remove("reading");
  Object.assign(window, {replay});  // for those who script the page
}

/** The page begins with the first picture. */
async function startLive(data: PageData, scene: Scene, signals: Signal[], address: URLSearchParams): Promise<Replay> {
  const feed = new LiveFeed(scene.frames.length, signals);
  do await feed.ask(); while (!feed.film.count);
  const replay = new Replay(data, scene, feed.film, signals, feed.events, feed.ledgerColumns(), address, true);
  replay.live = replay.stage.hand = new Live(replay, feed);
  return replay;
}

start().catch(error => {
  document.body.classList.remove("reading");
  byId("wait").textContent = `This page cannot be shown: ${error instanceof Error ? error.message : error}`;
  throw error;
});

// The address: replay.html#t=0.45&view=xz&azimuth=-40&elevation=30&trails=1&contacts=0&arrows=2&names=1&hide=lid&
// select=2&open=energy&play=1&theme=dark&webgl=0&beside=1
import type {Replay} from "./replay";

/** Puts time and view into the address and copies it. */
export function copyLink(replay: Replay): void {
  const {camera} = replay.stage, part = new URLSearchParams();
  part.set("t", String(Number(replay.t.toPrecision(9))));
  part.set("view", camera.view);
  if (replay.comparison.isBeside) part.set("beside", "1");
  if (!camera.isPlanar) {
    part.set("azimuth", String(Math.round(camera.azimuth * 180 / Math.PI)));
    part.set("elevation", String(Math.round(camera.elevation * 180 / Math.PI)));
  }
  if (replay.stage.forceFactor !== 1) part.set("arrows", String(Number(replay.stage.forceFactor.toPrecision(3))));
  for (const [key, names] of [["names", replay.tools.labelled], ["hide", replay.tools.unseen]] as const) {
    if (names.length) part.set(key, names.join(","));
  }
  history.replaceState(null, "", `#${part}`);  // unlike a new hash: no event
  navigator.clipboard?.writeText(location.href).catch(() => undefined);
}

export function readAddress(replay: Replay, part: URLSearchParams): void {
  const {camera} = replay.stage;
  for (const angle of ["azimuth", "elevation"] as const) {
    if (part.has(angle)) camera[angle] = Number(part.get(angle)) * Math.PI / 180;
  }
  if (part.has("view")) replay.setView(part.get("view") ?? "");
  else if (part.has("azimuth") || part.has("elevation")) { camera.look(); replay.stage.fit(); }
  for (const name of ["contacts", "trails"] as const) if (part.has(name)) replay.setSwitch(name, part.get(name) !== "0");
  const arrows = Number(part.get("arrows"));
  if (arrows > 0 && Number.isFinite(arrows)) replay.stage.forceFactor = arrows;
  replay.tools.choose(part.get("names"), part.get("hide"));
  if (part.has("theme")) replay.setTheme(part.get("theme") === "dark");
  const open = part.get("open");
  if (open) replay.showTab(open);
  const t = Number(part.get("t"));
  replay.pause().seek(part.has("t") && Number.isFinite(t) ? t : replay.t);
  if (part.has("select")) replay.select(Number(part.get("select")));
  if (part.get("play") === "1") replay.play();
}

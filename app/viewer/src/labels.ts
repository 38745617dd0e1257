// Words, icons and lists of the controls.

export const kSpeeds = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];
export const kViews: Record<string, string> = {xz: "x\u2013z", xy: "x\u2013y", yz: "y\u2013z", iso: "3D"};
export const kPlayIcon = '<svg viewBox="0 0 14 14"><path d="M2 0.5v13l11-6.5z"/></svg>';
export const kPauseIcon = '<svg viewBox="0 0 14 14"><path d="M2 1h3.6v12H2zM8.4 1H12v12H8.4z"/></svg>';
export const kThemeIcon = '<svg viewBox="0 0 16 16"><path d="M8 1a7 7 0 100 14A7 7 0 008 1zm0 1.5v11a5.5 5.5 0 010-11z"/></svg>';
export const kKeys: [string, string][] = [
  ["space", "play, pause"], ["\u2190 \u2192", "one frame back, on"], ["shift \u2190 \u2192", "a tenth of the film"],
  ["n p", "next, previous impact or switch"], ["home end", "first, last frame"], ["+ \u2212", "faster, slower"],
  ["l", "loop"], ["1 2 3 4", "view x\u2013z, x\u2013y, y\u2013z, 3D"], ["0", "fit"], ["c t", "contact forces, trails"],
  ["[ ]", "shorter, longer force arrows"],
  ["b m", "names of the bodies, measure"], ["h shift h", "hide the selected body, show all"], ["o w", "another run over this one; beside it"], ["f", "follow what is selected, else the body the model names, else the first"], ["s v", "save the picture, a film"],
  ["d", "light, dark"], ["drag", "turn (3D) or move; with shift: move"], ["wheel, two fingers", "zoom"],
  ["click", "name, state and place of a body"], ["in the curves", "click: to this time; drag: zoom; double click: all"]];

// Colours of the light and the dark page, for what is painted and not styled.

export interface Theme {
  dark: boolean; paper: string; grid: string; gridZero: string; ink: string; soft: string; ground: string;
  groundLine: string; hatch: string; edge: string; accent: string; sheet: string; still: string;
}

const kLight: Theme = {
  dark: false, paper: "#ffffff", grid: "#eff1f4", gridZero: "#dde2e8", ink: "#1f2933", soft: "#5f6c7b",
  ground: "#f3f4f6", groundLine: "#d5dae0", hatch: "#9aa5b1", edge: "#3e4c59", accent: "#1769aa",
  sheet: "rgba(140, 150, 162, .10)", still: "#a9b2bd"};
const kDark: Theme = {
  dark: true, paper: "#15191e", grid: "#1e242b", gridZero: "#303943", ink: "#e6eaee", soft: "#9aa7b4",
  ground: "#1c2229", groundLine: "#333d48", hatch: "#566270", edge: "#9aa7b4", accent: "#5aa9e6",
  sheet: "rgba(140, 150, 162, .14)", still: "#7f8b98"};

export let theme: Theme = kLight;
export function useTheme(dark: boolean): void { theme = dark ? kDark : kLight; }

export const kPalette = ["#3b82b8", "#d9803b", "#5a9e63", "#a066b0", "#c9a53a", "#c75b62", "#4aa3a2", "#7d8794"];
export const kCurves = ["#2b7bba", "#d2601a", "#3a9150", "#9258b5", "#b78a1c", "#c2485c", "#3a9d9c", "#77828f"];

/** What a contact does, in the order of the numbers in frames.bin. */
export const kStates = [
  {name: "open", colour: "#8a94a0"}, {name: "stick", colour: "#1f9d57"}, {name: "slip", colour: "#e0701a"},
  {name: "impact", colour: "#d81b72"}, {name: "spin", colour: "#8e5bd0"}];

/** "#rrggbb" mixed with white (share > 0) or black (share < 0). */
export function mixed(colour: string, share: number): string {
  const goal = share > 0 ? 255 : 0, s = Math.abs(share);
  const part = (i: number): string => {
    const x = parseInt(colour.slice(i, i + 2), 16);
    return Math.round(x + (goal - x) * s).toString(16).padStart(2, "0");
  };
  return "#" + part(1) + part(3) + part(5);
}

/** The colour a shape is given, or one by its frame; names of CSS are known by the browser. */
export function colourOf(shape: {colour?: string; frame: number}): string {
  if (shape.colour && /^#[0-9a-f]{6}$/i.test(shape.colour)) return shape.colour;
  if (shape.colour) {
    const ctx = document.createElement("canvas").getContext("2d");
    if (ctx) {
      ctx.fillStyle = "#010203";
      ctx.fillStyle = shape.colour;
      const seen = String(ctx.fillStyle);
      if (seen.startsWith("#") && seen !== "#010203") return seen;
    }
  }
  return shape.frame < 0 ? theme.still : kPalette[shape.frame % kPalette.length];
}

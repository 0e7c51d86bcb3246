// Colours of the 3D view, for light and dark surroundings. The first colours are those of plots.
import { Color } from "three";

export interface Palette {
  ground: string;
  grid: string;
  gridMajor: string;
  link: string;
  linkDark: string;
  accent: string;
  warning: string;
  tool: string;
  ghost: string;
  slow: string;
  middle: string;
  fast: string;
  way: string; // of a planned path
  force: string;
  shadow: number;
  light: number;
  fill: number;
  // Surfaces without gloss, which are drawn faster if there is no graphics processor.
  plain: boolean;
}

export const light: Palette = {
  ground: "#f4f5f7",
  grid: "#c9ced6",
  gridMajor: "#9aa3af",
  link: "#e0e4ea",
  linkDark: "#6a727e",
  accent: "#0072b2",
  warning: "#d55e00",
  tool: "#7b8490",
  ghost: "#0072b2",
  slow: "#0072b2",
  middle: "#8f63b8",
  fast: "#d55e00",
  way: "#009e73",
  force: "#b3267d",
  shadow: 0.28,
  light: 2.5,
  fill: 1.15,
  plain: false,
};

export const dark: Palette = {
  ground: "#14161a",
  grid: "#2e333b",
  gridMajor: "#4b525d",
  link: "#c6ccd4",
  linkDark: "#626b78",
  accent: "#3b9ddb",
  warning: "#f08a3c",
  tool: "#9aa3b0",
  ghost: "#4aa8e0",
  slow: "#4aa8e0",
  middle: "#b79be0",
  fast: "#f08a3c",
  way: "#2fc79a",
  force: "#e88cc4",
  shadow: 0.5,
  light: 2.2,
  fill: 0.8,
  plain: false,
};

// The colour for a speed from slow (0) to fast (1).
export function speedColor(palette: Palette, s: number, into = new Color()): Color {
  const [a, b, u] = s < 0.5 ? [palette.slow, palette.middle, 2 * s] : [palette.middle, palette.fast, 2 * s - 1];
  return into.set(a).lerp(new Color(b), Math.min(1, Math.max(0, u)));
}

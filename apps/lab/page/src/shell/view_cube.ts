// A cube that rotates with the view, and whose faces select points of view. Keys and the buttons beside it do the same.
import { el } from "../dom/dom.ts";
import type { SceneView } from "../scene/scene.ts";
import type { Side } from "../scene/stage.ts";

type Axis = readonly [number, number, number];
const HALF = 20; // px

// Each face with the directions to the right of its middle, below it and in front of it, in the world.
const FACES: [Side, string, Axis, Axis, Axis][] = [
  ["front", "Front", [1, 0, 0], [0, 0, -1], [0, -1, 0]],
  ["back", "Back", [-1, 0, 0], [0, 0, -1], [0, 1, 0]],
  ["side", "Right", [0, 1, 0], [0, 0, -1], [1, 0, 0]],
  ["left", "Left", [0, -1, 0], [0, 0, -1], [-1, 0, 0]],
  ["top", "Top", [1, 0, 0], [0, -1, 0], [0, 0, 1]],
  ["bottom", "Below", [1, 0, 0], [0, 1, 0], [0, 0, -1]],
];

const matrix = (...columns: (readonly number[])[]) => `matrix3d(${columns.flat().map((v) => +v.toFixed(5)).join()})`;

export function viewCube(scene: SceneView): HTMLElement {
  const faces = FACES.map(([side, label, right, below, front]) => el("button", {
    class: "face", tabindex: -1, style: `transform: ${matrix([...right, 0], [...below, 0], [...front, 0], [...front.map((v) => HALF * v), 1])}`, onclick: () => scene.look(side),
  }, label));
  const cube = el("div", { class: "cube" }, ...faces);
  scene.onTurn = (m) => {
    const column = (k: number) => [m[k]!, -m[k + 1]!, m[k + 2]!, 0]; // y points down on a page
    cube.style.transform = matrix(column(0), column(4), column(8), [0, 0, 0, 1]);
  };
  return el("div", { class: "view-cube", "aria-hidden": "true" }, cube);
}

// The tools over the 3D view: points of view, frames, the picture as a file, and the tool pose.
import { el, save, setText } from "../dom/dom.ts";
import type { Editor } from "../editor/editor.ts";
import { fixed, rollPitchYaw } from "../numbers/units.ts";
import type { SceneView } from "../scene/scene.ts";
import type { Preset } from "../scene/stage.ts";
import type { Intents } from "../store/intents.ts";
import { shownRun, type State } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import { videoButton } from "./video.ts";
import { viewCube } from "./view_cube.ts";

const PRESETS: [Preset, string][] = [["iso", "Iso"], ["front", "Front"], ["side", "Side"], ["top", "Top"], ["hand", "Hand"]];

const trimmed = (value: number, digits: number) => `${+value.toFixed(digits)}`;

// The joint values in the syntax of programs.
export function positionText(q: readonly number[], units: readonly ("rad" | "m")[]): string {
  const values = q.map((v, i) => (units[i] === "m" ? `${trimmed(1000 * v, 2)}mm` : `${trimmed((180 / Math.PI) * v, 2)}deg`));
  return `posJ(${values.join(", ")})`;
}

// The tool pose in the syntax of programs.
export function poseText(pose: readonly number[]): string {
  const mm = (i: number) => `${trimmed(1000 * (pose[i] ?? 0), 2)}mm`;
  const { roll, pitch, yaw } = rollPitchYaw(pose);
  const deg = (v: number) => `${trimmed((180 / Math.PI) * v, 2)}deg`;
  return `pose(x: ${mm(0)}, y: ${mm(1)}, z: ${mm(2)}, roll: ${deg(roll)}, pitch: ${deg(pitch)}, yaw: ${deg(yaw)})`;
}

function joints(state: State, robot: number): readonly number[] {
  if (state.pull?.robot === robot && state.pull.q) return state.pull.q;
  return shownRun(state)?.qAt(robot, state.t) ?? [];
}

// host    a column over the view, from top to bottom, so that nothing in it covers anything else.
// legend  of the speeds on the path, at the end of the last line.
export function sceneTools(host: HTMLElement, legend: HTMLElement, scene: SceneView, store: Store, intents: Intents, editor: Editor): void {
  const frames: HTMLButtonElement = el("button", { class: "tiny", "aria-pressed": "false", onclick: () => {
    scene.showFrames = !scene.showFrames;
    frames.setAttribute("aria-pressed", String(scene.showFrames));
    scene.redraw();
  } }, "Frames");
  const clearance: HTMLButtonElement = el("button", { class: "tiny", "aria-pressed": "false", title: "How near each robot is to something, and what touches", onclick: () => {
    scene.showClearance = intents.looksClosely = !scene.showClearance;
    clearance.setAttribute("aria-pressed", String(scene.showClearance));
    scene.redraw();
  } }, "Clearance");
  const torques: HTMLButtonElement = el("button", { class: "tiny", hidden: true, "aria-pressed": "false", title: "What the motors give, as shares of what they can give", onclick: () => {
    scene.showTorques = torques.getAttribute("aria-pressed") === "false";
    torques.setAttribute("aria-pressed", String(scene.showTorques));
    scene.redraw();
  } }, "Torques");
  const solids: HTMLButtonElement = el("button", { class: "tiny", hidden: true, "aria-pressed": "false", title: "Arms as the bodies with which collisions are found", onclick: () => {
    scene.showSolids = !scene.showSolids;
    solids.setAttribute("aria-pressed", String(scene.showSolids));
    scene.redraw();
  } }, "Solids");
  const robots = el("select", { "aria-label": "Robot", hidden: true, onchange: () => {
    scene.active = Number(robots.value);
    scene.redraw();
  } });
  const picture = async () => {
    const blob = await scene.picture();
    if (blob) save("view.png", blob);
  };
  // In a narrow view the other buttons are hidden until the user opens them; those that are on stay visible.
  const extra = el(
    "span", { class: "extra" }, frames, clearance, torques, solids,
    el("button", { class: "tiny", onclick: () => void picture() }, "PNG"),
    el("button", { class: "tiny", onclick: () => save("view.svg", new Blob([scene.drawing()], { type: "image/svg+xml" })) }, "SVG"),
    videoButton(scene.canvas, store, intents),
  );
  const more: HTMLButtonElement = el("button", { class: "tiny more", "aria-label": "More tools", title: "More tools", "aria-expanded": "false", onclick: () => more.setAttribute("aria-expanded", String(tools.classList.toggle("open"))) }, "…");
  const tools = el(
    "div", { class: "scene-tools", role: "toolbar", "aria-label": "3D view" },
    ...PRESETS.map(([preset, label]) => el("button", { class: "tiny preset", onclick: () => scene.look(preset) }, label)),
    el("button", { class: "tiny", onclick: () => scene.fit() }, "Fit"), robots, more, extra,
  );
  const where = el("output", { class: "where", "aria-label": "Hand" });
  const why = el("p", { class: "reason" });
  const insertJ = el("button", { class: "tiny", onclick: () => {
    const info = shownRun(store.state)?.robots[scene.active];
    if (info) editor.insertPosition(positionText(joints(store.state, scene.active), info.joints.map((j) => j.unit)), info.name);
  } }, "Insert posJ");
  const insertC = el("button", { class: "tiny", onclick: () => {
    const run = shownRun(store.state);
    const pose = run?.toolAt(scene.active, store.state.t);
    if (run && pose) editor.insertPosition(poseText(pose), run.robots[scene.active]!.name);
  } }, "Insert posC");
  host.prepend(tools, viewCube(scene));
  host.append(el("div", { class: "hand" }, why, where, insertJ, insertC, legend));
  scene.canvas.tabIndex = 0;
  scene.canvas.setAttribute("role", "img");
  scene.canvas.addEventListener("keydown", (event) => {
    const preset = PRESETS[Number(event.key) - 1];
    if (preset) scene.look(preset[0]);
    else if (event.key === "6") scene.fit();
    else return;
    event.preventDefault();
  });
  store.watch((s) => [s.shown, shownRun(s)?.version, s.t, s.pull], (s) => {
    const run = shownRun(s);
    const pose = run?.toolAt(scene.active, s.t);
    const names = run?.robots.map((r) => r.name) ?? [];
    if (robots.options.length !== names.length) robots.replaceChildren(...names.map((name, i) => el("option", { value: i }, name)));
    robots.hidden = names.length < 2;
    clearance.hidden = !intents.live && !run?.looks.length;
    solids.hidden = !run?.robots.some((robot) => robot.solids?.length || robot.pictures?.some((each) => each.use === "collision"));
    torques.hidden = !names.some((_, i) => run?.sharesAt(i, s.t).some((share) => share !== null));
    torques.setAttribute("aria-pressed", String(scene.showTorques ?? run?.elements.some((row) => row.kind === "torques") ?? false));
    setText(where, pose ? `${names[scene.active] ?? ""} at ${pose.slice(0, 3).map((v) => fixed(1000 * v, 1)).join(", ")} mm` : "");
    insertJ.hidden = insertC.hidden = !pose || !intents.live;
    setText(why, s.pull?.reason ?? "");
    scene.canvas.setAttribute("aria-label", `3D view: ${names.join(", ") || "no robot"}; ${where.textContent}`);
  });
}

// The pointer in the 3D view: paths under it are highlighted, a click goes to that instant or to the text, the handle drags the tool.
import { Plane, Raycaster, Vector2, Vector3, type Camera, type Mesh } from "three";
import { matrixPose, toolFrame } from "../store/kinematics.ts";
import type { Span } from "../protocol/messages.ts";
import type { Intents } from "../store/intents.ts";
import { shownRun, type State } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import type { PathView } from "./path.ts";
import type { Stage } from "./stage.ts";

// The data of the scene that the pointer needs.
export interface Pointed {
  canvas: HTMLCanvasElement;
  paths(): PathView[];
  active(): number; // the robot whose tool is dragged
  reach(): number; // radius of the cell, m
  pickObject(name: string, span: Span | null): void;
}

export class ScenePointer {
  private readonly store: Store;
  private readonly intents: Intents;
  private readonly stage: Stage;
  private readonly handle: Mesh;
  private readonly view: Pointed;
  private dragged: { robot: number; plane: Plane; offset: Vector3; pose: number[] } | null = null;

  constructor(store: Store, intents: Intents, stage: Stage, handle: Mesh, view: Pointed) {
    this.store = store;
    this.intents = intents;
    this.stage = stage;
    this.handle = handle;
    this.view = view;
    const { canvas } = view;
    let down: Vector2 | null = null;
    canvas.addEventListener("pointerdown", (event) => {
      down = new Vector2(event.clientX, event.clientY);
      if (this.startPull(event)) {
        event.stopImmediatePropagation();
        canvas.setPointerCapture(event.pointerId);
      }
    }, { capture: true });
    canvas.addEventListener("pointermove", (event) => {
      if (this.dragged) this.movePull(event);
      else if (!event.buttons) this.hoverPath(event);
    });
    canvas.addEventListener("pointerup", (event) => {
      if (this.dragged) this.finishPull();
      else if (down && down.distanceTo(new Vector2(event.clientX, event.clientY)) < 4) this.click(event);
    });
    canvas.addEventListener("pointerleave", () => this.setHover(null));
  }

  // The point of a body or the floor under a pointer, and whether that surface faces up; null: there is none.
  pointAt(event: { clientX: number; clientY: number }): { at: Vector3; isLevel: boolean } | null {
    const { ray } = this.place(event);
    const hit = ray.intersectObject(this.stage.content, true).find((each) => each.object.visible);
    if (hit) {
      const up = hit.face?.normal.clone().transformDirection(hit.object.matrixWorld).z ?? 0;
      return { at: hit.point, isLevel: up > 0.9 };
    }
    const at = ray.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), 0), new Vector3());
    return at && at.distanceTo(this.stage.controls.target) < 20 * this.view.reach() ? { at, isLevel: true } : null;
  }

  // The position of the pointer in the picture, and the ray from the camera through it.
  private place(event: { clientX: number; clientY: number }): { x: number; y: number; width: number; height: number; ray: Raycaster } {
    const box = this.view.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * x) / box.width - 1, 1 - (2 * y) / box.height), this.stage.camera as Camera);
    return { x, y, width: box.width, height: box.height, ray };
  }

  private setHover(hover: State["hover"]): void {
    if (this.store.state.hover === hover) return;
    this.store.change((s) => (s.hover = hover));
  }

  private hoverPath(event: PointerEvent): void {
    const run = shownRun(this.store.state);
    if (!run) return;
    const { x, y, width, height, ray } = this.place(event);
    this.view.canvas.style.cursor = this.handle.visible && ray.intersectObject(this.handle).length ? "grab" : "";
    const paths = this.view.paths();
    for (let robot = 0; robot < paths.length; robot++) {
      const t = paths[robot]!.timeAt(x, y, width, height, this.stage.camera, 10);
      if (t === null) continue;
      const line = run.moveAt(robot, t)?.span?.[0] ?? run.lineAt(t);
      this.setHover({ from: "path", robot, t, line });
      return;
    }
    if (this.store.state.hover?.from === "path") this.setHover(null);
  }

  private click(event: PointerEvent): void {
    const hover = this.store.state.hover;
    if (hover?.from === "path") {
      this.intents.goTo(hover.t);
      return;
    }
    const { ray } = this.place(event);
    const hit = ray.intersectObject(this.stage.content, true)[0];
    const name = hit?.object.userData["object"] ?? hit?.object.userData["robot"];
    const object = shownRun(this.store.state)?.objects.find((each) => each.name === name);
    if (typeof name === "string") this.view.pickObject(name, object?.span ?? null);
  }

  private startPull(event: PointerEvent): boolean {
    const run = shownRun(this.store.state);
    const robot = run?.robots[this.view.active()];
    if (!run || !robot || event.button !== 0 || !this.handle.visible) return false;
    const { ray } = this.place(event);
    const hit = ray.intersectObject(this.handle)[0];
    if (!hit) return false;
    const { t } = this.store.state;
    const pose = matrixPose(toolFrame(robot, run.qAt(this.view.active(), t), run.changeAt(this.view.active(), t)));
    const plane = new Plane().setFromNormalAndCoplanarPoint(this.stage.camera.getWorldDirection(new Vector3()), this.handle.position);
    this.dragged = { robot: this.view.active(), plane, offset: hit.point.clone().sub(this.handle.position), pose };
    this.stage.controls.enabled = false;
    return true;
  }

  private movePull(event: PointerEvent): void {
    const dragged = this.dragged!;
    const point = this.place(event).ray.ray.intersectPlane(dragged.plane, new Vector3());
    if (!point) return;
    point.sub(dragged.offset);
    void this.intents.pullHand(dragged.robot, [point.x, point.y, point.z, ...dragged.pose.slice(3)]);
  }

  private finishPull(): void {
    const pull = this.store.state.pull;
    const run = shownRun(this.store.state);
    this.dragged = null;
    this.stage.controls.enabled = true;
    const robot = pull && run?.robots[pull.robot];
    if (robot && pull.q) void this.intents.giveInput(robot.name, { joints: robot.name, values: pull.q }).then(() => this.intents.endPullHand());
    else this.intents.endPullHand();
  }
}

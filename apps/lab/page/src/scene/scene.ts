// The 3D view of the shown run at the shown instant.
import { Group, Matrix4, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from "three";
import type { Intents } from "../store/intents.ts";
import type { NearBody, Span } from "../protocol/messages.ts";
import { linkOfJoint, multiply, poseMatrix, rowsOf, toolFrame } from "../store/kinematics.ts";
import { NEAR, type Run } from "../store/run.ts";
import { halfExtents, isRound } from "../store/shapes.ts";
import { isStale, shownRun, type State } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import { ArmView } from "./arm.ts";
import { CamerasView } from "./cameras.ts";
import { ContactShadows, footprintOf, type Footprint } from "./contact.ts";
import { DrawingsView } from "./drawings.ts";
import { extent, grasped } from "./fingers.ts";
import { MeshLibrary } from "./meshes.ts";
import { overlaps } from "./near.ts";
import { ObjectsView } from "./objects.ts";
import { dark, light, type Palette } from "./palette.ts";
import { PathView } from "./path.ts";
import { ScenePointer } from "./pointer.ts";
import { boundsOf, Stage, type Preset } from "./stage.ts";
import { Clearances, Forces, pixelSize, type Force } from "./things.ts";
import { TorqueBars, type Bar } from "./torque_bars.ts";
import { Labels, Triads, type Label } from "./triad.ts";
import { floorLines, vectorPicture } from "./vector_picture.ts";
import { WaysView } from "./ways.ts";

export interface SceneHost {
  stage: HTMLElement;
  labels: HTMLElement;
  // An object or a robot was clicked: the editor shows its declaration.
  pickObject(name: string, span: Span | null): void;
  topSpeed(speed: number): void;
  // The bytes of a file that a description names.
  file(name: string): Promise<ArrayBuffer>;
}

const LEAST_FORCE = 0.05; // N: what would be shown as "0.0 N" is no arrow
const LATE = 0.3; // s: while playing, distances of this age are still shown

export class SceneView {
  private readonly store: Store;
  private readonly intents: Intents;
  private readonly host: SceneHost;
  private readonly stage: Stage;
  private readonly labels: Labels;
  private readonly triads = new Triads();
  private readonly named = new Triads();
  readonly library: MeshLibrary;
  private readonly objects: ObjectsView;
  private readonly drawings: DrawingsView;
  private readonly clearances = new Clearances();
  private readonly forces = new Forces();
  private readonly cameras = new CamerasView();
  private readonly ways: WaysView;
  private readonly torques = new TorqueBars();
  private readonly contact = new ContactShadows();
  private readonly handle: Mesh<SphereGeometry, MeshBasicMaterial>;
  private palette: Palette = light;
  private arms: ArmView[] = [];
  private ghosts = new Map<number, ArmView>();
  private paths: PathView[] = [];
  private oldPaths: PathView[] = [];
  private readonly ghostGroup = new Group();
  private described: unknown = null;
  private framed = "";
  private follow = false;
  readonly pointer: ScenePointer;
  showFrames = false;
  // Whether lines show the clearances; overlaps are always shown.
  showClearance = false;
  // Whether arms are drawn as the simplified shapes used for collision checks.
  showSolids = false;
  // Whether bars show motor torques; null: only for robots for which the laboratory has a row with torques.
  showTorques: boolean | null = null;
  // Called before each picture with the rotation from the world to the camera, in columns.
  onTurn: (columns: readonly number[]) => void = () => {};
  // The robot whose tool is dragged and whose pose is shown.
  active = 0;

  constructor(store: Store, intents: Intents, host: SceneHost) {
    this.store = store;
    this.intents = intents;
    this.host = host;
    this.stage = new Stage(host.stage);
    this.library = new MeshLibrary((name) => host.file(name), this.stage.software);
    this.library.changed = () => this.redraw();
    this.objects = new ObjectsView(this.stage.software, this.library);
    this.drawings = new DrawingsView(this.stage.software);
    this.ways = new WaysView(this.library);
    this.labels = new Labels(host.labels);
    this.handle = new Mesh(new SphereGeometry(1, 24, 16), new MeshBasicMaterial({ transparent: true, opacity: 0.35, depthTest: false, toneMapped: false }));
    this.handle.renderOrder = 5;
    this.stage.content.add(this.objects.group);
    this.stage.scene.add(this.triads.group, this.named.group, this.ghostGroup, this.handle, this.torques.group, this.contact.mesh, this.clearances.group, this.forces.group, this.ways.group, this.drawings.group, this.cameras.group);
    this.stage.before = () => this.beforePicture();
    this.stage.controls.addEventListener("start", () => (this.follow = false));
    const scheme = matchMedia("(prefers-color-scheme: dark)");
    const theme = () => {
      this.palette = { ...(scheme.matches ? dark : light), plain: this.stage.software };
      this.stage.theme(this.palette);
      this.handle.material.color.set(this.palette.accent);
      this.described = null;
      this.render(this.store.state);
    };
    scheme.addEventListener("change", theme);
    theme();
    this.frame("iso"); // a floor to look at, also before the first run
    this.pointer = new ScenePointer(store, intents, this.stage, this.handle, {
      canvas: this.canvas,
      paths: () => this.paths,
      active: () => this.active,
      reach: () => this.reach,
      pickObject: host.pickObject.bind(host),
    });
    store.watch(
      (s) => [s.shown, shownRun(s)?.version, s.ghost, s.ghost === null ? 0 : s.runs.get(s.ghost)?.version, s.t, shownRun(s)?.pictures, s.hover, s.pull, s.nearest, s.instant, isStale(s)],
      (s) => this.render(s),
    );
  }

  look(preset: Preset): void {
    this.follow = preset === "hand";
    if (!this.follow) this.stage.look(preset as Exclude<Preset, "hand">, this.bounds());
    this.stage.invalidate();
  }

  fit(): void {
    this.follow = false;
    this.frame(null);
  }

  private frame(preset: Exclude<Preset, "hand"> | null): void {
    const bounds = this.bounds();
    this.reach = bounds.radius;
    this.stage.fitSurroundings(bounds);
    this.stage.look(preset, bounds);
  }

  redraw(): void {
    this.render(this.store.state);
  }

  // The picture as it is now.
  picture(): Promise<Blob | null> {
    this.stage.draw();
    return new Promise((resolve) => this.stage.renderer.domElement.toBlob(resolve, "image/png"));
  }

  // The same as a vector picture.
  drawing(): string {
    const run = shownRun(this.store.state);
    if (!run) return "";
    const { t } = this.store.state;
    const arms = run.robots.map((robot, i) => {
      const arm = new ArmView(robot, this.palette, false, { round: 32, library: this.library });
      arm.stand(run.qAt(i, t), run.changeAt(i, t));
      this.standFingers(run, i, arm, t);
      return arm;
    });
    const { center } = this.bounds();
    const picture = vectorPicture([...arms.map((arm) => arm.group), this.objects.group, this.drawings.meshes()], this.stage.camera, {
      width: this.host.stage.clientWidth,
      height: this.host.stage.clientHeight,
      ground: this.palette.ground,
      below: floorLines(center.x, center.y, 1.6 * this.reach, 0.1, this.palette.grid),
      above: this.paths.flatMap((path) => path.strokes(this.palette, 3)),
    });
    for (const arm of arms) arm.dispose();
    return picture;
  }

  get canvas(): HTMLCanvasElement {
    return this.stage.renderer.domElement;
  }

  private bounds() {
    return boundsOf([this.stage.content, this.ghostGroup], [...this.paths.flatMap((path) => path.ends()), ...this.cameras.places()]);
  }

  private render(state: State): void {
    const run = shownRun(state);
    if (!run?.described) return;
    const key = [run.robots, this.palette];
    const same = Array.isArray(this.described) && key.every((k, i) => k === (this.described as unknown[])[i]);
    if (!same) {
      this.described = key;
      this.rebuild(run);
    }
    this.drawPaths(state, run);
    this.stand(state, run);
    this.stage.moved();
  }

  private rebuild(run: Run): void {
    for (const arm of [...this.arms, ...this.ghosts.values()]) arm.dispose();
    this.ways.clear();
    for (const path of [...this.paths, ...this.oldPaths]) {
      path.clear();
      path.group.removeFromParent();
    }
    this.ghosts.clear();
    this.arms = run.robots.map((robot) => new ArmView(robot, this.palette, false, { library: this.library }));
    this.paths = run.robots.map(() => new PathView());
    this.oldPaths = run.robots.map(() => new PathView());
    for (const arm of this.arms) this.stage.content.add(arm.group);
    for (const path of [...this.paths, ...this.oldPaths]) this.stage.scene.add(path.group);
    this.active = Math.min(this.active, Math.max(0, run.robots.length - 1));
    this.drawn = "";
  }

  private drawn = "";
  private drawPaths(state: State, run: Run): void {
    const ghost = state.ghost === null || state.ghost === run.id ? null : (state.runs.get(state.ghost) ?? null);
    const stale = isStale(state);
    const key = `${run.id} ${run.tracks.map((t) => t?.count).join()} ${ghost?.id} ${ghost?.tracks.map((t) => t?.count).join()} ${stale}`;
    if (key === this.drawn) return;
    this.drawn = key;
    this.lit = "";
    let top = 0;
    this.paths.forEach((path, i) => {
      const track = run.pathOf(i);
      if (track) path.draw(track, this.palette, stale ? "stale" : "shown", 0);
      else path.clear();
      top = Math.max(top, path.topSpeed);
    });
    this.oldPaths.forEach((path, i) => {
      const track = ghost?.pathOf(i);
      if (track) path.draw(track, this.palette, "ghost", 0);
      else path.clear();
    });
    this.host.topSpeed(top);
  }

  private lit = "";
  private stand(state: State, run: Run): void {
    const { t, hover, pull, nearest } = state;
    this.arms.forEach((arm, i) => {
      arm.asSolids = this.showSolids;
      arm.stand(run.qAt(i, t), run.changeAt(i, t));
      this.standFingers(run, i, arm, t);
    });
    this.objects.place(run, t);
    this.contact.show(this.footprints(run, t), 1.3 * this.palette.shadow);
    const ranges = run.robots.map((_, i) => litRanges(run, hover, i));
    const key = `${run.id} ${JSON.stringify(ranges)}`;
    if (key !== this.lit) {
      this.lit = key;
      this.paths.forEach((path, i) => path.light(ranges[i] ?? [], this.palette));
    }
    this.standGhosts(run, hover ? ranges : [], state);
    const labels: Label[] = [];
    this.drawings.place(run, t, labels);
    this.cameras.place(run, t, this.reach, this.palette, labels, this.showFrames);
    this.standFrames(run, t, labels);
    this.standTorques(run, t, labels);
    this.standThings(run, state, labels);
    if (pull?.reason && pull.nearest) labels.push({ text: tooFar(pull.nearest), at: pointOf(pull.nearest.pose), warning: true });
    else if (nearest) labels.push({ text: tooFar(nearest), at: pointOf(nearest.pose), warning: true });
    const failure = run.error;
    if (failure && run.robots.length) {
      const robot = Math.max(0, failure.robot ?? 0);
      // A goal may be far outside of the picture; the nearest reachable pose is not.
      const place = failure.nearest?.pose ?? failure.goal;
      const at = place ? pointOf(place) : new Vector3().setFromMatrixPosition(new Matrix4().fromArray(toolFrame(run.robots[robot]!, run.qAt(robot, run.tEnd), run.changeAt(robot, run.tEnd))));
      labels.push({ text: failure.nearest ? `${failure.message}: ${tooFar(failure.nearest)}` : failure.message, at, warning: true });
    }
    this.labels.set(labels);
    this.framePicture(run);
  }

  // Of the objects and of the bases of robots.
  private footprints(run: Run, t: number): Footprint[] {
    const feet = this.arms.flatMap((arm) => arm.footprints());
    const objects = run.objects.flatMap((object, i) => {
      const pose = run.objectAt(i, t);
      return pose ? [footprintOf(poseMatrix(pose), halfExtents(object), isRound(object))] : [];
    });
    return [...feet, ...objects];
  }

  private standGhosts(run: Run, ranges: [number, number][][], state: State): void {
    const wanted = new Map<number, readonly number[]>();
    run.robots.forEach((_, i) => {
      const range = ranges[i]?.at(-1);
      if (range && state.hover) wanted.set(i, run.qAt(i, state.hover.from === "text" ? range[1] : state.hover.t));
    });
    const nearest = run.error?.nearest;
    if (nearest && !state.hover) wanted.set(run.error?.robot ?? 0, nearest.q);
    if (state.nearest) wanted.set(state.nearest.robot, state.nearest.q);
    if (state.pull?.q) wanted.set(state.pull.robot, state.pull.q);
    for (const [i, arm] of this.ghosts) arm.group.visible = wanted.has(i);
    for (const [i, q] of wanted) {
      let arm = this.ghosts.get(i);
      if (!arm) {
        arm = new ArmView(run.robots[i]!, this.palette, true, { library: this.library });
        this.ghosts.set(i, arm);
        this.ghostGroup.add(arm.group);
      }
      arm.stand(q, run.changeAt(i, state.t));
      arm.group.visible = true;
    }
  }

  private standFingers(run: Run, robot: number, arm: ArmView, t: number): void {
    const stroke = (run.changeAt(robot, t)?.tool ?? run.robots[robot]!.tool).stroke;
    const along = arm.fingersAlong();
    const grasp = along && grasped(run, robot, t);
    const object = grasp && run.objects[grasp.object];
    const pose = grasp && run.objectAt(grasp.object, t);
    const width = object && pose ? extent(object, pose, [along!.x, along!.y, along!.z]) : stroke;
    arm.closeFingers(grasp ? (grasp.closed * Math.max(0, stroke - width)) / 2 : 0);
  }

  private standThings(run: Run, state: State, labels: Label[]): void {
    const { t, instant, playing } = state;
    const isNow = instant?.run === run.id && Math.abs(instant.t - t) < (playing ? LATE : 1e-6);
    const pairs = (isNow ? (instant.clearances ?? []) : []).filter((pair) => this.showClearance || overlaps(pair));
    this.clearances.show(pairs, this.palette, (body) => this.partOf(run, t, body), labels);
    const most = (robot: number) => Math.max(1e-9, run.topContact(robot));
    const points = (isNow ? (instant.presses ?? []) : []).map(({ robot, object, at, force }): Force => ({
      at: new Vector3(...at), force: new Vector3(...force), share: Math.hypot(...force) / Math.max(most(robot), Math.hypot(...force)), on: object,
    }));
    const forces = run.robots.flatMap((_, i): Force[] => {
      const force = run.contactAt(i, t);
      const tool = force && run.toolAt(i, t);
      return force && tool ? [{ at: pointOf(tool), force: new Vector3(...force), share: Math.hypot(...force) / most(i) }] : [];
    });
    const felt = [...forces, ...points].filter((each) => each.force.length() >= LEAST_FORCE);
    this.forces.show(felt, this.showClearance, this.reach, this.palette, labels);
    this.ways.show(run, t, this.palette);
  }

  private partOf(run: Run, t: number, body: NearBody): Group | null {
    if (!body.object) return body.robot === null ? null : (this.arms[body.robot]?.linkOf(body.link) ?? null);
    const found = run.objectNamed(body.object, t);
    return found && this.objects.viewOf(found.index);
  }

  // Named frames move with the bodies that carry them.
  private namedFrames(run: Run, t: number): { name: string; frame: Matrix4 }[] {
    const { instant } = this.store.state;
    if (instant?.run !== run.id) return [];
    return (instant.frames ?? []).flatMap(({ name, object, pose }) => {
      const carrier = object ? run.objectNamed(object, t) : null;
      if (object && !carrier) return [];
      const frame = carrier ? multiply(poseMatrix(carrier.pose), poseMatrix(pose)) : poseMatrix(pose);
      return [{ name, frame: new Matrix4().fromArray(frame) }];
    });
  }

  private standFrames(run: Run, t: number, labels: Label[]): void {
    const frames: Matrix4[] = [];
    run.robots.forEach((robot, i) => {
      const q = run.qAt(i, t);
      const tool = new Matrix4().fromArray(toolFrame(robot, q, run.changeAt(i, t)));
      const add = (frame: Matrix4, text: string) => {
        frames.push(frame);
        labels.push({ text, at: new Vector3().setFromMatrixPosition(frame) });
      };
      if (this.showFrames) {
        add(this.arms[i]!.frameOf(0), `${robot.name} base`);
        rowsOf(robot).forEach((_, k) => add(this.arms[i]!.frameOf(k + 1), robot.rows ? `${k + 1}` : (robot.joints[k]!.name ?? `${k + 1}`)));
        add(tool, "tool");
      }
      if (i === this.active) this.handle.position.setFromMatrixPosition(tool);
    });
    if (this.showFrames) {
      run.objects.forEach((object, i) => {
        const pose = run.objectAt(i, t);
        if (pose) frames.push(new Matrix4().fromArray(poseMatrix(pose)));
        if (pose) labels.push({ text: object.name, at: pointOf(pose) });
      });
    }
    this.triads.show(frames, 0.12 * this.reach);
    const named = this.namedFrames(run, t);
    this.named.show(named.map(({ frame }) => frame), 0.07 * this.reach);
    for (const { name, frame } of named) labels.push({ text: name, at: new Vector3().setFromMatrixPosition(frame), beside: true });
    this.handle.visible = this.intents.live && run.robots.length > 0;
  }

  private standTorques(run: Run, t: number, labels: Label[]): void {
    const bars: Bar[] = [];
    run.robots.forEach((robot, i) => {
      if (!(this.showTorques ?? run.elements.some((row) => row.kind === "torques" && row.robot === robot.name))) return;
      const shares = run.sharesAt(i, t);
      const most = shares.reduce<number>((best, share, k) => (Math.abs(share ?? 0) > Math.abs(shares[best] ?? 0) ? k : best), 0);
      shares.forEach((share, k) => {
        if (share === null) return;
        const at = new Vector3().setFromMatrixPosition(this.arms[i]!.frameOf(linkOfJoint(robot, k) + 1));
        bars.push({ at, share });
        const near = Math.abs(share) >= NEAR;
        if (near || k === most) labels.push({ text: `joint ${k + 1}: ${(100 * Math.abs(share)).toFixed(0)} %`, at, warning: near, beside: true });
      });
    });
    this.torques.show(bars, this.palette);
  }

  // For the first picture of other robots the camera moves so that all are visible.
  private reach = 0.5;
  private framePicture(run: Run): void {
    const key = JSON.stringify(run.robots.map((r) => [r.name, r.joints.length, r.T_world_base]));
    if (key === this.framed) return;
    this.framed = key;
    this.frame("iso");
  }

  private beforePicture(): void {
    const run = shownRun(this.store.state);
    const { camera, controls } = this.stage;
    if (this.follow && run?.robots[this.active]) {
      const { t } = this.store.state;
      const tool = new Matrix4().fromArray(toolFrame(run.robots[this.active]!, run.qAt(this.active, t), run.changeAt(this.active, t)));
      const back = 0.6 * this.reach;
      camera.position.set(0.35 * back, 0, -back).applyMatrix4(tool);
      controls.target.set(0, 0, 0.2 * back).applyMatrix4(tool);
      camera.up.set(0, 0, 1);
      camera.lookAt(controls.target);
    }
    this.handle.scale.setScalar(0.012 * camera.position.distanceTo(this.handle.position));
    const { clientWidth, clientHeight } = this.host.stage;
    camera.updateMatrixWorld();
    this.onTurn(camera.matrixWorldInverse.elements);
    this.torques.face(camera, clientHeight);
    const pixel = pixelSize(camera, clientHeight);
    this.clearances.face(pixel);
    this.forces.face(pixel);
    this.labels.place(camera, clientWidth, clientHeight);
  }
}

// The distance of the nearest pose from the goal; the complete reason is at the slider or in the problems.
export function tooFar({ distance, angle }: { distance: number; angle: number }): string {
  return distance >= 5e-5 ? `${(1000 * distance).toFixed(distance < 0.01 ? 1 : 0)} mm too far` : `turned ${((180 / Math.PI) * angle).toFixed(1)} deg too far`;
}

function pointOf(pose: readonly number[]): Vector3 {
  return new Vector3(pose[0], pose[1], pose[2]);
}

// The highlighted parts of a robot's path: the moves of the line under the pointer, or the move at its instant.
export function litRanges(run: Run, hover: State["hover"], robot: number): [number, number][] {
  if (!hover) return [];
  if (hover.from === "text") return run.movesOfLine(hover.line).filter((m) => m.robot === robot).map((m) => [m.t0, m.t1]);
  const move = hover.robot === robot ? run.moveAt(robot, hover.t) : undefined;
  return move ? [[move.t0, move.t1]] : [];
}

// All data of one run, and queries about it.
import type * as M from "../protocol/messages.ts";
import type { PictureAnswer } from "../protocol/pictures.ts";
import { DrawingRows } from "./drawings.ts";
import { changeAt, matrixPose, multiply, shapeFrames, toolFrame } from "./kinematics.ts";
import { Rows, Track } from "./rows.ts";

export interface Figure {
  title: string;
  svg: string;
  panels?: M.FigurePanel[];
}

// The newest picture of an element with its instant, or the reason why there is none.
export interface SeenPicture {
  key: string; // of the run with its inputs, and the instant
  t: number;
  picture: PictureAnswer | null;
  fault: string;
}

// The fraction of a motor limit above which a torque is near the limit.
export const NEAR = 0.8;

export class Run {
  readonly id: number;
  state: M.RunState = "running";
  tEnd = 0;
  textVersion = 0;
  label = "";
  parent: number | null = null;
  partsAt: number | null = null;
  hash = "";
  error: M.RunError | null = null;
  inputs: Record<string, unknown>[] = [];
  world = ""; // its name
  robots: M.RobotInfo[] = [];
  objects: M.ObjectInfo[] = [];
  cameras: M.CameraInfo[] = [];
  elements: M.ElementInfo[] = [];
  title = "";
  layout = "";
  moves: M.Move[] = [];
  statements: [number, number][] = [];
  ways: M.PlannedWay[] = [];
  stretches: M.Stretch[] = [];
  looks: M.Look[] = []; // of a recording, each complete, in the order of time
  events: M.ObjectEvent[] = [];
  drawings: M.DrawingInfo[] = [];
  drawingRows = new DrawingRows();
  notes: M.NoteItem[] = [];
  advice: M.RunAdvice[] = [];
  figures = new Map<number, Figure>();
  tracks: Track[] = [];
  objectRows = new Map<number, Rows>();
  elementRows = new Map<number, Rows>();
  forceRows = new Map<number, Rows>();
  contactRows = new Map<number, Rows>();
  // Values of elements at the time of the last request.
  values: Record<string, M.ElementValue> = {};
  valuesAt = -1;
  // Pictures of elements that were requested last, by name.
  pictures: ReadonlyMap<string, SeenPicture> = new Map();
  taken = 0; // number of pictures that its cameras took
  described = false;
  // Whether the end was shown when this run took the place of the one before; a run that has only begun looks as if it were at its end.
  followsEnd = true;
  // Counts received messages, so that views notice changes.
  version = 0;

  constructor(id: number) {
    this.id = id;
  }

  qAt(robot: number, t: number): number[] {
    const track = this.tracks[robot];
    return track?.count ? track.qAt(t) : (this.robots[robot]?.home ?? []);
  }

  // The base and tool of the robot at t, if they are not those at the start. The base of a hand moves with the arm that carries
  // it.
  changeAt(robot: number, t: number): M.RobotChange | undefined {
    const info = this.robots[robot];
    const change = info && changeAt(info, t);
    const carrier = info?.on === undefined ? undefined : this.robots[info.on];
    if (!info || !carrier) return change;
    const flange = shapeFrames(carrier, this.qAt(info.on!, t), this.changeAt(info.on!, t)?.T_world_base).at(-1)!;
    return {
      t: change?.t ?? 0,
      tool: change?.tool ?? info.tool,
      shapes: change?.shapes ?? info.shapes,
      solids: change?.solids ?? info.solids ?? [],
      T_world_base: multiply(flange, change?.T_world_base ?? info.T_world_base),
    };
  }

  // The path of its tool point; null for a hand on an arm, which has no rows while the arm carries it.
  pathOf(robot: number): Track | null {
    return (this.robots[robot]?.on ?? -1) < 0 ? (this.tracks[robot] ?? null) : null;
  }

  // The pose of a robot's tool.
  toolAt(robot: number, t: number): M.Pose | null {
    const info = this.robots[robot];
    if (!info) return null;
    const track = this.tracks[robot];
    return track?.count ? track.toolAt(t) : matrixPose(toolFrame(info, info.home, this.changeAt(robot, t)));
  }

  // The motor torques of a robot at t, N m or N; null: its masses are unknown.
  forcesAt(robot: number, t: number): number[] | null {
    const rows = this.forceRows.get(robot);
    return rows?.count ? rows.between(t, 1, rows.columns - 1) : null;
  }

  // The same as fractions of the motor limits; null where the limit is unknown.
  sharesAt(robot: number, t: number): (number | null)[] {
    const joints = this.robots[robot]?.joints ?? [];
    return (this.forcesAt(robot, t) ?? []).map((force, k) => (joints[k]?.max_force ? force / joints[k].max_force : null));
  }

  // The contact force on the tool point of a robot at t, N; null: none.
  contactAt(robot: number, t: number): [number, number, number] | null {
    const rows = this.contactRows.get(robot);
    if (!rows?.count || t < rows.time(0)) return null;
    const [x = 0, y = 0, z = 0] = rows.between(t, 1, 3);
    return x || y || z ? [x, y, z] : null;
  }

  // The largest contact force in the run, N.
  topContact(robot: number): number {
    const rows = this.contactRows.get(robot);
    let top = 0;
    for (let i = 0; i < (rows?.count ?? 0); i++) top = Math.max(top, Math.hypot(rows!.at(i, 1), rows!.at(i, 2), rows!.at(i, 3)));
    return top;
  }

  // The path around an obstacle that a robot follows at t, or is about to follow: the newest one planned until then, if its move has not
  // ended.
  wayAt(robot: number, t: number): M.PlannedWay | null {
    const way = this.ways.findLast((each) => each.robot === robot && each.t <= t + 1e-9);
    if (!way) return null;
    const move = this.moves.find((each) => each.robot === robot && each.t0 >= way.t - 1e-9 && each.t1 > each.t0);
    return t <= (move?.t1 ?? Infinity) + 1e-9 ? way : null;
  }

  // The pose of an object, or null while it does not exist.
  objectAt(index: number, t: number): M.Pose | null {
    const object = this.objects[index];
    if (!object) return null;
    let there: boolean | null = null;
    for (const event of this.events) {
      if (event.object !== index) continue;
      if (event.what === "added" && there === null && event.t > t) there = false;
      if (event.t > t) break;
      if (event.what === "added") there = true;
      if (event.what === "removed") there = false;
    }
    if (there === false) return null;
    const rows = this.objectRows.get(index);
    return rows?.count && rows.time(0) <= t ? rows.poseAt(t, 1) : object.pose;
  }

  // The object with that name that exists at t, and its pose.
  objectNamed(name: string, t: number): { index: number; pose: M.Pose } | null {
    for (let i = this.objects.length - 1; i >= 0; i--) {
      const pose = this.objects[i]!.name === name ? this.objectAt(i, t) : null;
      if (pose) return { index: i, pose };
    }
    return null;
  }

  // The robot that holds the object at t, or null.
  holderAt(object: number, t: number): number | null {
    let holder: number | null = null;
    for (const event of this.events) {
      if (event.t > t) break;
      if (event.object === object) holder = event.what === "attached" ? event.robot : event.what === "added" ? holder : null;
    }
    return holder;
  }

  // The data of a recording for the newest instant until t.
  lookAt(t: number): M.Look | undefined {
    return this.looks.findLast((look) => look.t <= t + 1e-9);
  }

  // The line on which the program is at t; null before its first statement.
  lineAt(t: number): number | null {
    let low = 0;
    let high = this.statements.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.statements[middle]![0] <= t) low = middle + 1;
      else high = middle;
    }
    return low ? this.statements[low - 1]![1] : null;
  }

  movesOfLine(line: number): M.Move[] {
    return this.moves.filter((move) => move.span && move.span[0] <= line && line <= move.span[2]);
  }

  moveAt(robot: number, t: number): M.Move | undefined {
    return this.moves.find((move) => move.robot === robot && move.t0 <= t && t <= move.t1);
  }

  // Instants at which something begins or ends, in order: the arrow keys stop there.
  stops(): number[] {
    const times = new Set<number>([0, this.tEnd]);
    for (const move of this.moves) times.add(move.t0).add(move.t1);
    return [...times].sort((a, b) => a - b);
  }
}

// Stores items of a growing list at their indices.
export function grow<T>(list: T[], first: number, items: T[]): void {
  if (first > list.length) return;
  list.length = first;
  for (const item of items) list.push(item);
}

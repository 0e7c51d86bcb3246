// Messages between the page and a laboratory: docs/lab-protocol.md says what each field means.

// [line from 1, column from 0 in UTF-16 units].
export type Position = [number, number];
// [line, column, line, column]; the end is not part of it.
export type Span = [number, number, number, number];
// [x, y, z, qw, qx, qy, qz], m.
export type Pose = number[];
// A rigid transformation, 16 numbers in columns.
export type Matrix = number[];

export interface Edit {
  span: Span;
  text: string;
}
export interface Fix {
  text: string;
  sure: boolean;
  edits: Edit[];
}
export interface Diagnostic {
  severity: "error" | "advice";
  code: string;
  message: string;
  span: Span | null;
  file?: string;
  label?: string | null;
  why?: string | null;
  fix?: Fix | null;
}

export interface JointInfo {
  name?: string;
  unit: "rad" | "m";
  lower: number;
  upper: number;
  max_speed: number;
  max_force?: number | null;
  T_before_joint: Matrix;
  T_joint_link: Matrix;
}
// A link of a robot in which one joint moves several links: its joint value is ratio q + offset, where q is the value of that joint.
export interface RowInfo {
  unit: "rad" | "m";
  T_before_joint: Matrix;
  T_joint_link: Matrix;
  joint: number;
  ratio: number;
  offset: number;
}
export interface Shape {
  link: number;
  kind: "capsule" | "cylinder" | "ring" | "box";
  role: string;
  T: Matrix;
  radius?: number;
  length?: number;
  thickness?: number;
  size?: number[];
  given?: boolean; // by a description: drawn in addition to the pictures of its link, not replaced by them
}
// The picture of a link, drawn instead of its shapes: a GLB file, rotated to z up and moved by T.
export interface LinkPicture {
  link: number;
  file: string;
  T: Matrix;
  use?: "picture" | "collision"; // missing: both
}
export interface ToolInfo {
  kind: string;
  stroke: number;
  radius: number;
  length: number;
  T_flange_tool: Matrix;
}
export interface RobotChange {
  t: number;
  tool: ToolInfo;
  T_world_base: Matrix;
  shapes?: Shape[];
  solids?: Shape[];
}
export interface RobotInfo {
  name: string;
  home: number[];
  joints: JointInfo[];
  rows?: RowInfo[]; // missing: joint i moves link i
  on?: number; // the robot whose flange carries the base, in whose frame T_world_base is then; -1: none
  T_world_base: Matrix;
  tool: ToolInfo;
  shapes: Shape[];
  solids?: Shape[]; // simplified shapes for collision checks
  pictures?: LinkPicture[];
  changes?: RobotChange[];
}
export interface ObjectInfo {
  name: string;
  shape: string;
  size: number[];
  color: string;
  mass?: number;
  pose: Pose;
  file?: string; // of a mesh, which T moves into the frame of the object
  T?: Matrix;
  texture?: string;
  span?: Span | null;
}
// The properties of a drawing that stay the same while its pose and sizes change.
export interface DrawingInfo {
  t: number;
  name: string;
  kind: string; // "arrow", "line", "text", "disk", "ellipsoid" or "capsule"
  text: string;
  color: string;
  robot: number | null; // that carries it: at its tool point if `link` is -1, otherwise at a link
  link: number;
  object: string; // the name of the object that carries it; empty: none
  span?: Span | null;
}
// A camera, in the frame of its carrier: z forward, x right, y down. Lengths of its lens are in pixels.
export interface CameraInfo {
  name: string;
  size: [number, number];
  focal: [number, number];
  centre: [number, number];
  robot: number | null; // that carries it, at a link, 0 being the base
  link: number;
  object: string; // the name of the object that carries it; empty: none
  T: Matrix;
}
export interface Coordinate {
  name: string;
  unit?: string | null;
  lower?: number | null;
  upper?: number | null;
  value?: number | null;
}
export interface ElementInfo {
  kind: string;
  name: string;
  label?: string | null;
  robot?: string | null;
  axes?: Coordinate[] | null;
  value?: number | string | boolean | null;
  range?: [number, number] | null;
  unit?: string | null;
  units?: string[] | null;
  type?: string | null;
  image?: string | null;
  file?: string; // of an image
  span?: Span | null;
  factor?: number | null;
  header?: string[] | null;
  labels?: string[] | null;
  text?: string | null;
  camera?: string; // of a view
  overlay?: string;
  wanted?: [number, number][];
}

export type ObjectChange = "added" | "attached" | "detached" | "removed" | "fell";
export interface ObjectEvent {
  t: number;
  what: ObjectChange;
  object: number;
  robot: number | null;
}
export interface Move {
  robot: number;
  motion?: number;
  span: Span | null;
  t0: number;
  t1: number;
  text: string;
  stopped?: boolean;
}
// An interval in which a task executed a statement, or a signal had a value.
export interface Stretch {
  kind: "task" | "signal";
  name: string;
  t0: number;
  t1: number;
  span?: Span | null;
  value?: number | boolean;
}
// A path around obstacles, as it was planned at t; it takes `duration`, s.
export interface PlannedWay {
  robot: number;
  t: number;
  duration: number;
  path: [number, number, number][];
  arms: number[][];
}
export interface NoteItem {
  t: number;
  kind: "output" | "message" | "advice";
  text: string;
  span?: Span | null;
  element?: string; // the button whose function printed it
}
// Advice that the run gave at t.
export type RunAdvice = Diagnostic & { t: number };
export type RunError = Diagnostic & { t: number; when?: string | null; robot?: number | null; goal?: Pose | null; nearest?: Nearest | null };
export type RunState = "running" | "done" | "failed" | "stopped";
export interface RunHead {
  run: number;
  state: RunState;
  t_end: number;
  label?: string | null;
  parent?: number | null;
  parts_at?: number | null;
}
export interface RunMessage extends RunHead {
  type: "run";
  text_version: number;
  inputs?: Record<string, unknown>[];
  pictures?: number; // number of pictures that its cameras took
  hash?: string | null;
  error?: RunError | null;
}
export interface Variable {
  scope: number;
  name: string;
  type: string;
  value: string | null;
  declared?: Span | null;
}
export interface TaskInfo {
  name: string;
  waits?: string | null;
  line?: number | null;
  calls?: string[];
}
// A value of a program: numbers in SI, lists, matrices as lists of rows, records as objects.
export type Value = number | string | boolean | null | Value[] | { [name: string]: Value };
// The unit of all numbers of a value, or those of its parts.
export type Units = string | Units[] | { [name: string]: Units };
export interface ElementValue {
  value?: Value;
  units?: Units;
  image?: string | null;
  error?: string | null;
}
export interface Words {
  keywords: string[];
  types: string[];
  functions: string[];
  units: string[];
  soft: string[];
}
export interface Welcome {
  type: "welcome";
  protocol: number;
  page: number;
  version?: string;
  file: string;
  text: string;
  text_version: number;
  title?: string | null;
  layout?: string | null;
  demo?: boolean;
  key?: string;
  words?: Partial<Words>;
}
export interface Description {
  type: "description";
  run: number;
  world?: string | null;
  robots: RobotInfo[];
  objects: ObjectInfo[];
  cameras?: CameraInfo[];
  elements?: ElementInfo[] | null;
  title?: string | null;
  layout?: string | null;
}
// A frame with a name, in the frame of an object or in the world ("").
export interface NamedFrame {
  name: string;
  object: string;
  pose: Pose;
}
// A body: a part of a robot, its payload, or an object; and its point that is nearest to another body.
export interface NearBody {
  robot: number | null;
  object: string;
  link: number;
  text: string;
  at: [number, number, number];
}
export interface NearPair {
  distance: number;
  at_least?: boolean; // they may overlap by more
  felt?: boolean; // there is a contact force: the tool presses into the other one
  body: NearBody;
  other: NearBody;
}
export interface InstantMessage {
  type: "instant";
  run: number;
  t: number;
  cursor?: boolean;
  line: number | null;
  at_breakpoint?: boolean;
  ended?: boolean;
  variables: Variable[];
  tasks?: TaskInfo[];
  signals?: { name: string; value: string | number | boolean | null }[];
  frames?: NamedFrame[];
  clearances?: NearPair[];
  presses?: Press[];
  values?: Record<string, ElementValue>; // of elements, if the question did not move the cursor
}
// A point at which a robot presses on something: the point, m, and the contact force on the robot, N.
export interface Press {
  robot: number;
  object: string;
  at: [number, number, number];
  force: [number, number, number];
}
// The data of a recording for an instant, without what is equal to the instant before.
export interface Look {
  t: number;
  instant: Partial<InstantMessage>;
  values: Record<string, ElementValue>;
}
export interface CompletionItem {
  text: string;
  kind?: string;
  detail?: string | null;
}
export interface Nearest {
  q: number[];
  pose: Pose;
  distance: number;
  angle: number;
}
export interface Overload {
  text: string;
  parameters: [number, number][];
  help?: string | null;
}
export interface Comparison {
  type: "comparison";
  run: number;
  with: number;
  same: boolean;
  same_until?: number | null;
  parts_at?: number | null;
  line?: number | null;
  line_with?: number | null;
}
export interface FigureAxis {
  label: string;
  unit: string; // SI
  log: boolean;
}
// A figure in the plane, or one of its panels: values in SI, null where they are no numbers.
export interface FigurePanel {
  title: string;
  x: FigureAxis;
  y: FigureAxis;
  right: FigureAxis;
  series: { kind: "line" | "points" | "bars"; label: string; right: boolean; x: (number | null)[]; y: (number | null)[] }[];
}
interface Grown<T> {
  run: number;
  first: number;
  items: T[];
}

// From the laboratory to the page.
export type Incoming = { to?: number | null } & (
  | Welcome
  | Description
  | RunMessage
  | InstantMessage
  | Comparison
  | { type: "control"; holder: number | null; pages: number[]; wishes?: number[]; names?: Record<string, string> }
  | { type: "text"; text: string; text_version: number; from?: number }
  | { type: "diagnostics"; text_version: number; runs: boolean; items: Diagnostic[] }
  | { type: "shown"; run: number }
  | { type: "runs"; list: RunHead[] }
  | ({ type: "moves" } & Grown<Move>)
  | ({ type: "ways" } & Grown<PlannedWay>)
  | ({ type: "stretches" } & Grown<Stretch>)
  | ({ type: "statements" } & Grown<[number, number]>)
  | ({ type: "objects" } & Grown<ObjectEvent>)
  | ({ type: "drawings" } & Grown<DrawingInfo>)
  | ({ type: "notes" } & Grown<NoteItem>)
  | ({ type: "advice" } & Grown<RunAdvice>)
  | { type: "figures"; run: number; index: number; title?: string | null; svg: string; panels?: FigurePanel[] }
  | { type: "elements"; run: number; t: number; values: Record<string, ElementValue> }
  | { type: "breakpoints"; lines: number[]; known?: number[] }
  | { type: "completion"; replaced?: Span | null; items: CompletionItem[]; more?: boolean }
  | { type: "hover"; span: Span | null; text?: string | null; help?: string | null; value?: string | null; messages?: string[] }
  | { type: "signature"; overloads: Overload[]; active?: number; parameter?: number }
  | { type: "definition"; span: Span | null; file?: string | null }
  | { type: "formatted"; text: string | null }
  | { type: "inverse"; ok: boolean; q?: number[] | null; reason?: string | null; nearest?: Nearest | null }
  | { type: "looks"; run: number; items: Look[] }
  | { type: "taken"; run: number }
  | { type: "kept"; name: string; size: [number, number, number] }
  | { type: "exported"; laboratory: Record<string, unknown> }
  | { type: "document"; text: string; exists: boolean; changed: boolean }
  | { type: "saved" }
  | { type: "error"; reason: string; message: string; robot?: number; goal?: Pose; nearest?: Nearest | null }
);
export type IncomingOf<T extends Incoming["type"]> = Extract<Incoming, { type: T }>;

export type StepHow = "over" | "into" | "out" | "back" | "continue";
export type Input = { set: string; value: number | string | boolean } | { press: string } | { joints: string; values: number[] } | { hand: string; pose: Pose } | { hand: string; values: number[] };

// From the page to the laboratory; `seq` is added when it is sent.
export type Outgoing =
  | { type: "hello"; protocol: 1; key?: string }
  | { type: "text"; text: string; version: number; run?: boolean; change?: number }
  | { type: "name"; name: string }
  | { type: "complete" | "hover" | "signature" | "definition"; at: Position }
  | { type: "format" | "stop" | "export" | "take" }
  | { type: "goto"; t: number; run?: number; looks?: boolean }
  | ({ type: "input"; t?: number } & Input)
  | { type: "breakpoints"; lines: number[] }
  | { type: "step"; how: StepHow }
  | { type: "show" | "fetch"; run: number }
  | { type: "compare"; run: number; with: number }
  | { type: "file"; name: string }
  | { type: "picture"; element: string; t: number; run?: number }
  | { type: "keep"; name: string; base85: string; first: boolean; last: boolean }
  | { type: "give"; to?: number }
  | { type: "save"; replaces?: boolean }
  | { type: "inverse"; robot: string; pose: Pose; seed?: number[] };

// Frames of an arm from its description.
import type { Matrix, RobotChange, RobotInfo, RowInfo } from "../protocol/messages.ts";

export function multiply(a: Matrix, b: Matrix): Matrix {
  const c = new Array<number>(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[4 * k + row]! * b[4 * column + k]!;
      c[4 * column + row] = sum;
    }
  }
  return c;
}

// A pose [x, y, z, qw, qx, qy, qz] as a matrix.
export function poseMatrix(pose: readonly number[]): Matrix {
  const [x = 0, y = 0, z = 0, w = 1, i = 0, j = 0, k = 0] = pose;
  return [
    1 - 2 * (j * j + k * k), 2 * (i * j + k * w), 2 * (i * k - j * w), 0,
    2 * (i * j - k * w), 1 - 2 * (i * i + k * k), 2 * (j * k + i * w), 0,
    2 * (i * k + j * w), 2 * (j * k - i * w), 1 - 2 * (i * i + j * j), 0,
    x, y, z, 1,
  ];
}

// A rigid matrix as a pose.
export function matrixPose(m: Matrix): number[] {
  const [xx, yx, zx, , xy, yy, zy, , xz, yz, zz] = m as [number, ...number[]];
  const q = [1 + xx! + yy! + zz!, 1 + xx! - yy! - zz!, 1 - xx! + yy! - zz!, 1 - xx! - yy! + zz!].map((s) => Math.sqrt(Math.max(0, s)) / 2);
  const signed = [q[0]!, q[1]! * (zy! < yz! ? -1 : 1), q[2]! * (xz! < zx! ? -1 : 1), q[3]! * (yx! < xy! ? -1 : 1)];
  if (q[0]! < 1e-6) {
    // A half turn: the signs follow from the products of its axis.
    const k = q.indexOf(Math.max(...q.slice(1)), 1);
    const products = [[xx!, xy! + yx!, xz! + zx!], [xy! + yx!, yy!, yz! + zy!], [xz! + zx!, yz! + zy!, zz!]];
    for (let i = 1; i < 4; i++) signed[i] = i === k ? q[i]! : Math.sign(products[k - 1]![i - 1]!) * q[i]!;
  }
  return [m[12]!, m[13]!, m[14]!, ...signed];
}

function jointMatrix(unit: "rad" | "m", q: number): Matrix {
  if (unit === "m") return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, q, 1];
  const [c, s] = [Math.cos(q), Math.sin(q)];
  return [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}

// How each link moves: as the joint of its number, or as its row says.
export function rowsOf(robot: RobotInfo): readonly RowInfo[] {
  return robot.rows ?? robot.joints.map((joint, i) => ({ ...joint, joint: i, ratio: 1, offset: 0 }));
}

// The link that a joint moves itself, counted from 0; links that copy it follow.
export function linkOfJoint(robot: RobotInfo, joint: number): number {
  const own = rowsOf(robot).findIndex((row) => row.joint === joint && row.ratio === 1 && row.offset === 0);
  return own < 0 ? joint : own;
}

// The frames in which shapes stand, in the world: the base, each joint's T_before_joint M(q), the
// flange, which is the last link.
export function shapeFrames(robot: RobotInfo, q: readonly number[], base: Matrix = robot.T_world_base): Matrix[] {
  const frames = [base];
  let link = base;
  for (const row of rowsOf(robot)) {
    const moved = multiply(multiply(link, row.T_before_joint), jointMatrix(row.unit, row.ratio * (q[row.joint] ?? 0) + row.offset));
    frames.push(moved);
    link = multiply(moved, row.T_joint_link);
  }
  frames.push(link);
  return frames;
}

// The tool's frame in the world.
export function toolFrame(robot: RobotInfo, q: readonly number[], change?: RobotChange): Matrix {
  const tool = change?.tool ?? robot.tool;
  return multiply(shapeFrames(robot, q, change?.T_world_base).at(-1)!, tool.T_flange_tool);
}

// What the robot's base and tool are at t, if that changed since the start.
export function changeAt(robot: RobotInfo, t: number): RobotChange | undefined {
  return robot.changes?.findLast((change) => change.t <= t);
}

// Joints within a hundredth of their range of a limit.
export function jointsAtLimits(robot: RobotInfo, q: readonly number[]): boolean[] {
  return robot.joints.map((joint, i) => {
    const margin = 0.01 * (joint.upper - joint.lower);
    const value = q[i] ?? 0;
    return value <= joint.lower + margin || value >= joint.upper - margin;
  });
}

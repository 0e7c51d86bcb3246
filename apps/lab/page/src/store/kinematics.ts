// Frames of an arm from its description.
import { Matrix4, Quaternion } from "three";
import type { Matrix, RobotChange, RobotInfo, RowInfo } from "../protocol/messages.ts";

const matrix = (m: Matrix) => new Matrix4().fromArray(m);

export function multiply(a: Matrix, b: Matrix): Matrix {
  return matrix(a).multiply(matrix(b)).toArray();
}

// A pose [x, y, z, qw, qx, qy, qz] as a matrix.
export function poseMatrix([x = 0, y = 0, z = 0, qw = 1, qx = 0, qy = 0, qz = 0]: readonly number[]): Matrix {
  return new Matrix4().makeRotationFromQuaternion(new Quaternion(qx, qy, qz, qw)).setPosition(x, y, z).toArray();
}

// A rigid matrix as a pose, with qw >= 0.
export function matrixPose(m: Matrix): number[] {
  const { w, x, y, z } = new Quaternion().setFromRotationMatrix(matrix(m));
  return [m[12]!, m[13]!, m[14]!, ...[w, x, y, z].map((part) => (w < 0 ? -part : part))];
}

// The motion of each link: by the joint of its number, or by its row.
export function rowsOf(robot: RobotInfo): readonly RowInfo[] {
  return robot.rows ?? robot.joints.map((joint, i) => ({ ...joint, joint: i, ratio: 1, offset: 0 }));
}

// The link that a joint moves directly, counted from 0; links of mimic joints follow.
export function linkOfJoint(robot: RobotInfo, joint: number): number {
  const own = rowsOf(robot).findIndex((row) => row.joint === joint && row.ratio === 1 && row.offset === 0);
  return own < 0 ? joint : own;
}

// The frames of the shapes, in the world: the base, T_before_joint M(q) of each joint, and the flange, which is the last
// link.
export function shapeFrames(robot: RobotInfo, q: readonly number[], base: Matrix = robot.T_world_base): Matrix[] {
  const link = matrix(base);
  const frames: Matrix[] = [base];
  for (const row of rowsOf(robot)) {
    const value = row.ratio * (q[row.joint] ?? 0) + row.offset;
    const moved = new Matrix4();
    link.multiply(matrix(row.T_before_joint)).multiply(row.unit === "m" ? moved.makeTranslation(0, 0, value) : moved.makeRotationZ(value));
    frames.push(link.toArray());
    link.multiply(matrix(row.T_joint_link));
  }
  frames.push(link.toArray());
  return frames;
}

// The tool's frame in the world.
export function toolFrame(robot: RobotInfo, q: readonly number[], change?: RobotChange): Matrix {
  const tool = change?.tool ?? robot.tool;
  return multiply(shapeFrames(robot, q, change?.T_world_base).at(-1)!, tool.T_flange_tool);
}

// The base and tool of the robot at t, if they have changed since the start.
export function changeAt(robot: RobotInfo, t: number): RobotChange | undefined {
  return robot.changes?.findLast((change) => change.t <= t);
}

// Whether each joint is closer to a limit than one hundredth of its range.
export function jointsAtLimits(robot: RobotInfo, q: readonly number[]): boolean[] {
  return robot.joints.map((joint, i) => {
    const margin = 0.01 * (joint.upper - joint.lower);
    const value = q[i] ?? 0;
    return value <= joint.lower + margin || value >= joint.upper - margin;
  });
}

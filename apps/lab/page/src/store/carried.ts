// The pose of a body that a robot or an object carries.
import type { Matrix } from "../protocol/messages.ts";
import { multiply, poseMatrix, rowsOf, shapeFrames, toolFrame } from "./kinematics.ts";
import type { Run } from "./run.ts";

// robot   its number, or null. link: -1: its tool point; 0: the base; i: link i, the last one being the flange.
// object  the name of an object; empty: none. Without robot and object the body is fixed in the world.
export interface Carrier {
  robot: number | null;
  link: number;
  object: string;
}

// The frame of the carrier in the world; null: it does not exist.
export function carrierFrame(run: Run, t: number, { robot, link, object }: Carrier): Matrix | null {
  return robot === null ? frameOfObject(run, t, object) : frameOfLink(run, t, robot, link);
}

function frameOfObject(run: Run, t: number, object: string): Matrix | null {
  if (!object) return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const found = run.objectNamed(object, t);
  return found && poseMatrix(found.pose);
}

function frameOfLink(run: Run, t: number, robot: number, link: number): Matrix | null {
  const info = run.robots[robot];
  if (!info) return null;
  const change = run.changeAt(robot, t);
  const q = run.qAt(robot, t);
  if (link < 0) return toolFrame(info, q, change);
  const frame = shapeFrames(info, q, change?.T_world_base)[link];
  const row = link > 0 ? rowsOf(info)[link - 1] : undefined;
  if (!frame) return null;
  return row ? multiply(frame, row.T_joint_link) : frame;
}

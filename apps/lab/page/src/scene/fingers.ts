// The opening of a gripper: programs grasp and release at an instant, and the drawn fingers close on the held
// object.
import type { ObjectInfo } from "../protocol/messages.ts";
import { poseMatrix } from "../store/kinematics.ts";
import type { Run } from "../store/run.ts";
import { halfExtents, isRound } from "../store/shapes.ts";

const TAKES = 0.15; // s during which the picture changes, before the grasp and after the release

// The extent of an object along a direction of the world, m.
export function extent(object: ObjectInfo, pose: readonly number[], along: readonly [number, number, number]): number {
  const m = poseMatrix(pose);
  const inside = [0, 4, 8].map((c) => Math.abs(m[c]! * along[0] + m[c + 1]! * along[1] + m[c + 2]! * along[2])) as [number, number, number];
  const [x, y, z] = halfExtents(object);
  if (object.shape === "sphere") return 2 * x;
  if (!isRound(object)) return 2 * (x * inside[0] + y * inside[1] + z * inside[2]);
  const radius = object.shape === "cone" ? x / 2 : x; // where its frame is
  return 2 * (radius * Math.hypot(inside[0], inside[1]) + z * inside[2]);
}

// The object that a robot holds at t, is about to grasp or has just released, and the closed fraction of the motion of its fingers: 0 to
// 1.
export function grasped(run: Run, robot: number, t: number): { object: number; closed: number } | null {
  let held: number | null = null;
  for (const event of run.events) {
    const own = event.what === "attached" && event.robot === robot;
    if (event.t > t) {
      if (own && held === null && event.t - t < TAKES) return { object: event.object, closed: 1 - (event.t - t) / TAKES };
      if (event.t - t >= TAKES) break;
      continue;
    }
    if (own) held = event.object;
    else if (held === event.object && event.what !== "added") {
      held = null;
      if (t - event.t < TAKES && event.what === "detached") return { object: event.object, closed: 1 - (t - event.t) / TAKES };
    }
  }
  return held === null ? null : { object: held, closed: 1 };
}

// Names of joints for lists and matrices with a number for each joint.
import type { RobotInfo } from "../protocol/messages.ts";

export const namesOf = (robot: RobotInfo): string[] => robot.joints.map((joint, k) => joint.name || `q${k + 1}`);

// The units of values for the joints of a robot: of positions, speeds, accelerations and torques.
const KINDS: Record<"rad" | "m", string>[] = [
  { rad: "rad", m: "m" }, { rad: "rad/s", m: "m/s" }, { rad: "rad/s^2", m: "m/s^2" }, { rad: "Nm", m: "N" }, { rad: "N m", m: "N" },
];

// The names of the joints if columns with these units (SI) are values for the joints of a robot; null: they are something else. Two or three
// angles may also be an orientation: then the titles of the plot decide.
export function jointNames(units: readonly string[] | null | undefined, columns: number, robots: readonly RobotInfo[], titles: readonly string[]): string[] | null {
  if (!units || columns < 2) return null;
  const robot = robots.find(({ joints }) => joints.length === columns && KINDS.some((kind) => joints.every((joint, k) => units[k] === kind[joint.unit])));
  if (!robot) return null;
  const isSure = columns > 3 || new Set(units).size > 1 || titles.some((title) => /joint|torque|tau|^qd{0,2}$/i.test(title));
  return isSure ? namesOf(robot) : null;
}

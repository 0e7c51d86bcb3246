// Quantities for display: degrees and millimetres for joint values and tool poses.

export interface Shown {
  unit: string;
  factor: number; // shown number = factor * SI
  digits: number;
}

const SHOWN: Record<string, Shown> = {
  rad: { unit: "deg", factor: 180 / Math.PI, digits: 1 },
  m: { unit: "mm", factor: 1000, digits: 1 },
  "rad/s": { unit: "deg/s", factor: 180 / Math.PI, digits: 1 },
  "rad/s^2": { unit: "deg/s²", factor: 180 / Math.PI, digits: 1 },
  "m/s": { unit: "mm/s", factor: 1000, digits: 1 },
  "m/s^2": { unit: "mm/s²", factor: 1000, digits: 1 },
  Nm: { unit: "N m", factor: 1, digits: 3 },
};

// `per` is "", "/s" or "/s^2".
export function shownUnit(unit: string | null | undefined, per = ""): Shown {
  const shown = SHOWN[unit ?? ""];
  return shown ? { ...shown, unit: shown.unit + per } : { unit: (unit ?? "") + (unit ? per : ""), factor: 1, digits: 3 };
}

export function written(si: number, shown: Shown): string {
  return fixed(si * shown.factor, shown.digits);
}

// A number that is rounded to zero has no sign.
export function fixed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

// The rotation angles of a pose about z, y and x, as yaw, pitch and roll: R = Rz(yaw) Ry(pitch) Rx(roll).
export function rollPitchYaw(pose: readonly number[]): { roll: number; pitch: number; yaw: number } {
  const [, , , w = 1, x = 0, y = 0, z = 0] = pose;
  return {
    roll: Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    pitch: Math.asin(Math.min(1, Math.max(-1, 2 * (w * y - z * x)))),
    yaw: Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  };
}

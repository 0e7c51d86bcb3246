// Rows of numbers in the order of time, in one growing array; the first column is the time, s.
import type { RowBlock } from "../protocol/rows.ts";

export class Rows {
  readonly columns: number;
  values: Float64Array;
  count = 0;

  constructor(columns: number) {
    this.columns = columns;
    this.values = new Float64Array(columns * 64);
  }

  // Stores the rows of a block from index `first` on; `first: 0` starts again.
  add(block: RowBlock): void {
    if (block.columns !== this.columns || block.first > this.count) return;
    const end = block.first + block.count;
    const needed = end * this.columns;
    if (needed > this.values.length) {
      const larger = new Float64Array(Math.max(needed, 2 * this.values.length));
      larger.set(this.values.subarray(0, this.count * this.columns));
      this.values = larger;
    }
    this.values.set(block.rows, block.first * this.columns);
    this.count = end;
  }

  at(i: number, column: number): number {
    return this.values[i * this.columns + column] ?? 0;
  }

  time(i: number): number {
    return this.at(i, 0);
  }

  // The last row at or before t; 0 before the first.
  indexAt(t: number): number {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.time(middle) <= t) low = middle + 1;
      else high = middle;
    }
    return Math.max(0, low - 1);
  }

  column(k: number): Float64Array {
    const values = new Float64Array(this.count);
    for (let i = 0; i < this.count; i++) values[i] = this.at(i, k);
    return values;
  }

  // `length` columns from column `from` at t, interpolated linearly between rows.
  between(t: number, from: number, length: number): number[] {
    const i = this.indexAt(t);
    const j = Math.min(i + 1, this.count - 1);
    const dt = this.time(j) - this.time(i);
    const s = dt > 0 ? Math.min(1, Math.max(0, (t - this.time(i)) / dt)) : 0;
    const values = new Array<number>(length);
    for (let k = 0; k < length; k++) values[k] = (1 - s) * this.at(i, from + k) + s * this.at(j, from + k);
    return values;
  }

  // A pose in seven columns; its quaternion is interpolated along the shorter arc.
  poseAt(t: number, from: number): number[] {
    const pose = this.between(t, from, 7);
    const i = this.indexAt(t);
    const j = Math.min(i + 1, this.count - 1);
    let dot = 0;
    for (let k = 3; k < 7; k++) dot += this.at(i, from + k) * this.at(j, from + k);
    if (dot < 0) for (let k = 3; k < 7; k++) pose[k] = this.at(i, from + k);
    const norm = Math.hypot(pose[3]!, pose[4]!, pose[5]!, pose[6]!) || 1;
    for (let k = 3; k < 7; k++) pose[k] = pose[k]! / norm;
    return pose;
  }
}

// The motion of one robot: t, q, qd, qdd of each joint, the pose of the tool.
export class Track extends Rows {
  readonly joints: number;

  constructor(joints: number) {
    super(8 + 3 * joints);
    this.joints = joints;
  }

  qAt(t: number): number[] {
    return this.between(t, 1, this.joints);
  }

  toolAt(t: number): number[] {
    return this.poseAt(t, 1 + 3 * this.joints);
  }

  tool(i: number): [number, number, number] {
    const from = 1 + 3 * this.joints;
    return [this.at(i, from), this.at(i, from + 1), this.at(i, from + 2)];
  }

  // Speed of the tool between row i and the next, m/s.
  toolSpeed(i: number): number {
    const j = Math.min(i, this.count - 2);
    if (j < 0) return 0;
    const [a, b] = [this.tool(j), this.tool(j + 1)];
    const dt = this.time(j + 1) - this.time(j);
    return dt > 1e-9 ? Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) / dt : 0;
  }
}

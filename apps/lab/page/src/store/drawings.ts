// Drawings of a run, and the pose of each at a time.
import type { RowBlock } from "../protocol/rows.ts";
import { Rows } from "./rows.ts";

export const DRAWING_COLUMNS = 12; // t, number, pose (7), sizes (3)

// One list of rows for all drawings; the rows of each are in the order of time.
export class DrawingRows extends Rows {
  private ofShape: number[][] = [];

  constructor() {
    super(DRAWING_COLUMNS);
  }

  override add(block: RowBlock): void {
    if (block.columns !== this.columns || block.first > this.count) return;
    let i = this.count;
    if (block.first < this.count) {
      this.ofShape = [];
      i = 0;
    }
    super.add(block);
    for (; i < this.count; i++) (this.ofShape[this.at(i, 1)] ??= []).push(i);
  }

  // The row of a drawing at t; -1: it is not shown then.
  rowAt(shape: number, t: number): number {
    const rows = this.ofShape[shape] ?? [];
    let low = 0;
    let high = rows.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.time(rows[middle]!) <= t + 1e-9) low = middle + 1;
      else high = middle;
    }
    const row = rows[low - 1];
    return row !== undefined && this.at(row, 9) > 0 ? row : -1;
  }
}

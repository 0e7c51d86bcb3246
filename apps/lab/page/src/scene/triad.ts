// Frames as thin triads with a name, and labels at points of the scene.
import { AxesHelper, Group, Vector3, type Camera, type Matrix4 } from "three";

const COLORS = ["#d1495b", "#2a9d58", "#2f6fde"] as const;

export interface Label {
  text: string;
  at: Vector3;
  warning?: boolean;
  // Leaves space for a bar at that point.
  beside?: boolean;
  // A text of the program: its height in the scene, m, in its own colour, and exactly at its point.
  height?: number;
  color?: string;
}

const SMALLEST = 7; // px, of a text of the program
const LARGEST = 160;

export class Triads {
  readonly group = new Group();

  show(frames: Matrix4[], size: number): void {
    while (this.group.children.length > frames.length) this.group.children.at(-1)!.removeFromParent();
    frames.forEach((frame, i) => {
      let axes = this.group.children[i] as AxesHelper | undefined;
      if (!axes) {
        axes = new AxesHelper(1);
        axes.setColors(...COLORS);
        axes.matrixAutoUpdate = false;
        const material = axes.material as { depthTest: boolean };
        material.depthTest = false;
        axes.renderOrder = 4;
        this.group.add(axes);
      }
      axes.matrix.copy(frame).scale(new Vector3(size, size, size));
    });
    this.group.updateMatrixWorld(true);
  }
}

// Texts over the picture; a text may come from a program and is never parsed as HTML.
export class Labels {
  private readonly host: HTMLElement;
  private labels: Label[] = [];

  constructor(host: HTMLElement) {
    this.host = host;
  }

  set(labels: Label[]): void {
    this.labels = labels;
    while (this.host.children.length > labels.length) this.host.lastElementChild!.remove();
    labels.forEach((label, i) => {
      const element = (this.host.children[i] as HTMLElement | undefined) ?? this.host.appendChild(document.createElement("span"));
      element.className = `label${label.warning ? " warning" : ""}${label.beside ? " beside" : ""}${label.height ? " drawn" : ""}`;
      element.style.color = label.color ?? "";
      if (!label.height) element.style.fontSize = "";
      if (element.textContent !== label.text) element.textContent = label.text;
    });
  }

  // A label that would overlap another one moves down; the last labels are not moved.
  place(camera: Camera, width: number, height: number): void {
    const taken: { x: number; y: number; wide: number; high: number }[] = [];
    for (let i = this.labels.length - 1; i >= 0; i--) {
      const p = this.labels[i]!.at.clone().project(camera);
      const element = this.host.children[i] as HTMLElement;
      const { height: high3d } = this.labels[i]!;
      if (high3d) {
        element.hidden = p.z > 1;
        const depth = -this.labels[i]!.at.clone().applyMatrix4(camera.matrixWorldInverse).z;
        const pixels = (high3d * camera.projectionMatrix.elements[5]! * height) / (2 * Math.max(1e-6, depth));
        element.style.fontSize = `${Math.min(LARGEST, Math.max(SMALLEST, pixels)).toFixed(1)}px`;
        element.style.transform = `translate(${(((p.x + 1) / 2) * width).toFixed(1)}px, ${(((1 - p.y) / 2) * height).toFixed(1)}px) translate(-50%, -50%)`;
        continue;
      }
      // Warnings are shown at the edge, too.
      element.hidden = p.z > 1 || (!this.labels[i]!.warning && Math.max(Math.abs(p.x), Math.abs(p.y)) > 1.1);
      if (element.hidden) continue;
      const [wide, high] = [element.offsetWidth, element.offsetHeight];
      const x = Math.max(0, Math.min(((p.x + 1) / 2) * width, width - wide - 12));
      let y = Math.max(12, Math.min(((1 - p.y) / 2) * height, height - high));
      for (let k = 0; k < 6; k++) {
        const under = taken.find((other) => x < other.x + other.wide && other.x < x + wide && y < other.y + other.high && other.y < y + high);
        if (!under) break;
        y = under.y + under.high;
      }
      taken.push({ x, y, wide, high });
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
  }
}

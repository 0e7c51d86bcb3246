// Frames as thin triads with a name, and labels that stay at a point of the scene.
import { AxesHelper, Group, Vector3, type Camera, type Matrix4 } from "three";

const COLORS = ["#d1495b", "#2a9d58", "#2f6fde"] as const;

export interface Label {
  text: string;
  at: Vector3;
  warning?: boolean;
  // Leaves room for a bar at that point.
  beside?: boolean;
}

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

// Text over the picture; text comes from programs and is never read as HTML.
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
      element.className = `label${label.warning ? " warning" : ""}${label.beside ? " beside" : ""}`;
      if (element.textContent !== label.text) element.textContent = label.text;
    });
  }

  place(camera: Camera, width: number, height: number): void {
    this.labels.forEach((label, i) => {
      const p = label.at.clone().project(camera);
      const element = this.host.children[i] as HTMLElement;
      element.hidden = p.z > 1 || Math.abs(p.x) > 1.1 || Math.abs(p.y) > 1.1;
      const x = Math.max(0, Math.min(((p.x + 1) / 2) * width, width - element.offsetWidth - 12));
      const y = Math.max(12, Math.min(((1 - p.y) / 2) * height, height - element.offsetHeight));
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    });
  }
}

// Planned paths around obstacles: the path of the tool, and transparent copies of the arm along it.
import { Group } from "three";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import type { PlannedWay } from "../protocol/messages.ts";
import type { Run } from "../store/run.ts";
import { ArmView } from "./arm.ts";
import type { MeshLibrary } from "./meshes.ts";
import type { Palette } from "./palette.ts";

class WayView {
  readonly group = new Group();
  readonly way: PlannedWay;
  private readonly line: Line2;
  private readonly arms: ArmView[];

  constructor(run: Run, way: PlannedWay, palette: Palette, library: MeshLibrary) {
    this.way = way;
    const geometry = new LineGeometry();
    geometry.setPositions(way.path.flat());
    this.line = new Line2(geometry, new LineMaterial({ linewidth: 2.5, dashed: true, dashSize: 0.02, gapSize: 0.012, transparent: true, depthTest: false, depthWrite: false, toneMapped: false }));
    this.line.material.color.set(palette.way);
    this.line.computeLineDistances();
    this.line.frustumCulled = false;
    this.line.renderOrder = 3;
    this.arms = way.arms.filter((_, i) => i % 2 === 0).map((q) => { // more of them would hide each other
      const arm = new ArmView(run.robots[way.robot]!, { ...palette, ghost: palette.way }, true, { round: 24, library, opacity: 0.13 });
      arm.stand(q, run.changeAt(way.robot, way.t));
      this.group.add(arm.group);
      return arm;
    });
    this.group.add(this.line);
  }

  dispose(): void {
    for (const arm of this.arms) arm.dispose();
    this.line.geometry.dispose();
    this.line.material.dispose();
    this.group.removeFromParent();
  }
}

export class WaysView {
  readonly group = new Group();
  private views: WayView[] = [];
  private readonly library: MeshLibrary;

  constructor(library: MeshLibrary) {
    this.library = library;
  }

  show(run: Run, t: number, palette: Palette): void {
    const wanted = run.robots.flatMap((_, i) => run.wayAt(i, t) ?? []);
    if (wanted.length === this.views.length && wanted.every((way, i) => way === this.views[i]!.way)) return;
    this.clear();
    this.views = wanted.filter((way) => way.path.length > 1).map((way) => new WayView(run, way, palette, this.library));
    for (const view of this.views) this.group.add(view.group);
  }

  clear(): void {
    for (const view of this.views) view.dispose();
    this.views = [];
  }
}

// The dark area under an object on the floor or close to it, where little ambient light arrives: it shows the contact. The shadow of a
// lamp does not, because it begins beside the object.
import { InstancedBufferAttribute, InstancedMesh, Matrix4, PlaneGeometry, Quaternion, ShaderMaterial, Vector3 } from "three";

const MOST = 256;
const HIGHEST = 0.08; // m above the floor: a higher object has no dark area

// An area on the floor: its centre, its rotation about z, its half sizes, and the height of the object above the floor.
export interface Footprint {
  x: number;
  y: number;
  turn: number;
  half: [number, number];
  height: number;
  round?: boolean;
}

const material = () => new ShaderMaterial({
  uniforms: { darkness: { value: 0.3 } },
  transparent: true,
  depthWrite: false,
  vertexShader: `
    attribute vec4 extent; // half sizes, width of the edge, strength
    attribute float corner;
    varying vec2 at;
    varying vec4 area;
    varying float radius;
    void main() {
      area = extent;
      radius = corner;
      at = position.xy * 2.0 * (extent.xy + extent.z);
      gl_Position = projectionMatrix * viewMatrix * instanceMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: `
    varying vec2 at;
    varying vec4 area;
    varying float radius;
    uniform float darkness;
    void main() {
      vec2 outside = max(abs(at) - (area.xy - radius), 0.0);
      float edge = clamp((length(outside) - radius) / area.z, 0.0, 1.0);
      gl_FragColor = vec4(0.0, 0.0, 0.0, darkness * area.w * (1.0 - edge) * (1.0 - edge));
    }`,
});

export class ContactShadows {
  readonly mesh: InstancedMesh<PlaneGeometry, ShaderMaterial>;
  private readonly extent = new InstancedBufferAttribute(new Float32Array(4 * MOST), 4);
  private readonly corner = new InstancedBufferAttribute(new Float32Array(MOST), 1);

  constructor() {
    const plane = new PlaneGeometry(1, 1);
    plane.setAttribute("extent", this.extent);
    plane.setAttribute("corner", this.corner);
    this.mesh = new InstancedMesh(plane, material(), MOST);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -1;
    this.mesh.count = 0;
  }

  show(footprints: readonly Footprint[], darkness: number): void {
    let count = 0;
    const scale = new Vector3();
    const up = new Vector3(0, 0, 1);
    for (const { x, y, turn, half, height, round } of footprints) {
      if (height > HIGHEST || height < -0.02 || count >= MOST) continue;
      const smaller = Math.min(...half);
      const edge = Math.max(0.008, 0.45 * smaller) + Math.max(0, height);
      const strength = 1 - Math.max(0, height) / HIGHEST;
      this.extent.setXYZW(count, half[0], half[1], edge, strength);
      this.corner.setX(count, round ? smaller : 0);
      scale.set(2 * (half[0] + edge), 2 * (half[1] + edge), 1);
      this.mesh.setMatrixAt(count, new Matrix4().compose(new Vector3(x, y, -0.0003), new Quaternion().setFromAxisAngle(up, turn), scale));
      count++;
    }
    this.mesh.count = count;
    this.mesh.visible = count > 0;
    this.mesh.instanceMatrix.needsUpdate = this.extent.needsUpdate = this.corner.needsUpdate = true;
    this.mesh.material.uniforms["darkness"]!.value = darkness;
  }
}

// The area of an object whose frame has these columns: `half` are its half sizes along x, y and z.
export function footprintOf(frame: readonly number[], half: readonly [number, number, number], round = false): Footprint {
  const [x = 0, y = 0, z = 0] = frame.slice(12, 15);
  const reach = (row: number) => [0, 1, 2].reduce((sum, k) => sum + Math.abs(frame[4 * k + row]!) * half[k]!, 0);
  const height = z - reach(2);
  const upright = [0, 1, 2].find((k) => Math.abs(frame[4 * k + 2]!) > 0.999);
  // The area of a tilted object is about as large as its extents along x and y.
  if (upright === undefined) return { x, y, turn: 0, half: [0.8 * reach(0), 0.8 * reach(1)], height };
  const [a, b] = [(upright + 1) % 3, (upright + 2) % 3] as [number, number];
  return { x, y, turn: Math.atan2(frame[4 * a + 1]!, frame[4 * a]!), half: [half[a]!, half[b]!], height, ...(round && upright === 2 ? { round } : {}) };
}

// Renderer, camera, light and floor. Draws only when something has changed.
import {
  Box3, type BufferGeometry, DirectionalLight, Group, HemisphereLight, MathUtils, Mesh, PCFShadowMap, PerspectiveCamera, PlaneGeometry,
  Scene, ShaderMaterial, ShadowMaterial, Sphere, Vector3, WebGLRenderer, Color, NeutralToneMapping,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Palette } from "./palette.ts";

const floorShader = {
  vertexShader: `
    varying vec2 at;
    void main() {
      at = (modelMatrix * vec4(position, 1.0)).xy;
      gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: `
    varying vec2 at;
    uniform vec3 minor;
    uniform vec3 major;
    uniform float reach;
    float line(float step, float width) {
      vec2 cell = at / step;
      vec2 wide = fwidth(cell) * width;
      vec2 near = abs(fract(cell - 0.5) - 0.5);
      vec2 on = (1.0 - smoothstep(wide * 0.5, wide * 1.2, near)) * (1.0 - smoothstep(0.25, 0.6, wide));
      return max(on.x, on.y);
    }
    void main() {
      float fade = 1.0 - smoothstep(0.35, 1.0, length(at) / reach);
      float thick = line(1.0, 1.1);
      float thin = line(0.1, 1.0);
      gl_FragColor = vec4(mix(minor, major, thick), max(thick * 0.75, thin * 0.4) * fade);
      #include <colorspace_fragment>
    }`,
};

export type Side = "front" | "back" | "side" | "left" | "top" | "bottom";
export type Preset = "iso" | "hand" | Side;

const DIRECTIONS: Record<Exclude<Preset, "hand">, [number, number, number]> = {
  iso: [1, -1.15, 0.95],
  front: [0, -1, 0.08],
  back: [0, 1, 0.08],
  side: [1, 0, 0.08],
  left: [-1, 0, 0.08],
  top: [0, -0.001, 1],
  bottom: [0, -0.3, -1],
};

// Without a graphics processor the processor draws each picture, without smooth edges. Since the start is slow there too, the renderer
// that was started to find out is used.
function startDrawing(): { renderer: WebGLRenderer; software: boolean } {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("webgl2", { alpha: true, antialias: false });
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  const name = names ? String(context?.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  const software = /swiftshader|llvmpipe|software|basic render/i.test(name);
  if (context && software) return { renderer: new WebGLRenderer({ canvas, context }), software };
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return { renderer: new WebGLRenderer({ antialias: true }), software: false };
}

const TALL = 0.76; // of the height of the view that buttons and texts do not cover

export class Stage {
  readonly scene = new Scene();
  readonly content = new Group();
  readonly camera = new PerspectiveCamera(32, 1, 0.01, 100);
  readonly renderer: WebGLRenderer;
  readonly controls: OrbitControls;
  // Called before each picture.
  before: () => void = () => {};
  after: () => void = () => {};
  private readonly key = new DirectionalLight(0xffffff, 2.4);
  private readonly rim = new DirectionalLight(0xffffff, 1); // from behind, so that edges are visible
  private readonly sky = new HemisphereLight(0xffffff, 0xb8bcc4, 0.8);
  private readonly floor: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly shade: Mesh<PlaneGeometry, ShadowMaterial>;
  private dirty = false;
  // Whether the processor draws, not a graphics processor.
  readonly software: boolean;

  constructor(host: HTMLElement) {
    const { renderer, software } = startDrawing();
    this.renderer = renderer;
    this.software = software;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.autoUpdate = false; // only moved bodies change the shadows
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.toneMapping = NeutralToneMapping;
    this.camera.up.set(0, 0, 1);
    host.append(this.renderer.domElement);
    this.key.castShadow = true;
    this.key.shadow.mapSize.setScalar(software ? 1024 : 2048);
    this.key.shadow.radius = software ? 3 : 6;
    this.key.shadow.bias = -0.0004;
    this.key.shadow.normalBias = 0.004;
    this.sky.position.set(0, 0, 1);
    this.rim.position.set(0.9, 0.8, 0.7);
    this.floor = new Mesh(
      new PlaneGeometry(1, 1),
      new ShaderMaterial({
        ...floorShader,
        uniforms: { minor: { value: new Color() }, major: { value: new Color() }, reach: { value: 4 } },
        transparent: true,
        depthWrite: false,
      }),
    );
    this.shade = new Mesh(new PlaneGeometry(1, 1), new ShadowMaterial({ opacity: 0.3, depthWrite: false }));
    this.shade.receiveShadow = true;
    this.floor.position.z = -0.001;
    this.shade.position.z = -0.0005;
    this.floor.renderOrder = -2;
    this.shade.renderOrder = -1;
    this.scene.add(this.content, this.key, this.key.target, this.rim, this.sky, this.floor, this.shade);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.maxPolarAngle = Math.PI * 0.94;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.invalidate());
    new ResizeObserver(() => this.resize(host)).observe(host);
    this.resize(host);
  }

  theme(palette: Palette): void {
    this.scene.background = new Color(palette.ground);
    (this.floor.material.uniforms["minor"]!.value as Color).set(palette.grid);
    (this.floor.material.uniforms["major"]!.value as Color).set(palette.gridMajor);
    this.shade.material.opacity = palette.shadow;
    this.key.intensity = palette.light;
    this.sky.intensity = palette.fill;
    this.rim.intensity = 0.45 * palette.light;
    this.invalidate();
  }

  invalidate(): void {
    if (this.dirty) return;
    this.dirty = true;
    requestAnimationFrame(() => {
      this.dirty = false;
      this.draw();
    });
  }

  // Arms or objects have moved.
  moved(): void {
    this.renderer.shadowMap.needsUpdate = true;
    this.invalidate();
  }

  // Draws at once, so that the picture can be read.
  draw(): void {
    this.before();
    this.renderer.render(this.scene, this.camera);
    this.after();
  }

  // Sets floor, light and limits of zooming for a scene with these bounds.
  fitSurroundings(bounds: Sphere): void {
    const r = Math.max(0.2, bounds.radius);
    const reach = Math.max(1.5, 3.2 * r);
    for (const mesh of [this.floor, this.shade]) mesh.scale.set(2 * reach, 2 * reach, 1);
    this.floor.material.uniforms["reach"]!.value = reach;
    this.key.target.position.copy(bounds.center);
    this.key.position.copy(bounds.center).add(new Vector3(-0.35, -0.95, 1.6).setLength(4 * r));
    const shadow = this.key.shadow.camera;
    shadow.left = shadow.bottom = -1.5 * r;
    shadow.right = shadow.top = 1.5 * r;
    shadow.near = 0.5 * r;
    shadow.far = 8 * r;
    shadow.updateProjectionMatrix();
    this.renderer.shadowMap.needsUpdate = true;
    this.controls.minDistance = 0.15 * r;
    this.controls.maxDistance = 14 * r;
    this.camera.near = 0.02 * r;
    this.camera.far = 60 * r;
    this.camera.updateProjectionMatrix();
  }

  // Moves the camera to a side, or keeps its direction, as near as possible with all points visible between the controls over the view.
  look(preset: Exclude<Preset, "hand"> | null, { center, points }: Bounds): void {
    const back = (preset ? new Vector3(...DIRECTIONS[preset]) : this.camera.position.clone().sub(this.controls.target)).normalize();
    const right = new Vector3(0, 0, 1).cross(back).normalize();
    const tangent = Math.tan(MathUtils.degToRad(this.camera.fov / 2));
    let distance = 0.1;
    const target = center.clone();
    for (const [axis, slope] of [[right, 0.9 * tangent * this.camera.aspect], [back.clone().cross(right), TALL * tangent]] as const) {
      let [low, high] = [Infinity, -Infinity];
      for (const point of points) {
        const from = point.clone().sub(center);
        const [along, near] = [from.dot(axis), slope * from.dot(back)];
        low = Math.min(low, along - near);
        high = Math.max(high, along + near);
      }
      distance = Math.max(distance, (high - low) / (2 * slope));
      target.addScaledVector(axis, (high + low) / 2);
    }
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(back, distance);
    this.camera.up.set(0, 0, 1);
    this.controls.update();
    this.invalidate();
  }

  private resize(host: HTMLElement): void {
    const { clientWidth: width, clientHeight: height } = host;
    if (!width || !height) return;
    const ratio = Math.min(2, devicePixelRatio);
    if (ratio !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(ratio); // this clears the picture, too
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }
}

// A sphere around everything, and extreme points of the bodies in it.
export interface Bounds extends Sphere {
  points: Vector3[];
}

function cornersOf(box: Box3): Vector3[] {
  const { min, max } = box;
  return [min.x, max.x].flatMap((x) => [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new Vector3(x, y, z))));
}

export function boundsOf(groups: Group[], given: Vector3[]): Bounds {
  const points = [...given];
  for (const group of groups) {
    group.updateWorldMatrix(true, true);
    group.traverseVisible((node) => {
      if (!(node instanceof Mesh)) return;
      const geometry = node.geometry as BufferGeometry;
      if (!geometry.boundingBox) geometry.computeBoundingBox();
      for (const corner of cornersOf(geometry.boundingBox!)) points.push(corner.applyMatrix4(node.matrixWorld));
    });
  }
  if (!points.length) points.push(...cornersOf(new Box3(new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 0.5))));
  return Object.assign(new Box3().setFromPoints(points).getBoundingSphere(new Sphere()), { points });
}

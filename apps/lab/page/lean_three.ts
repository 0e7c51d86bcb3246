// Three without what this page does not draw. Its parts are taken one by one, so that what nothing needs stays out; some that its
// renderer and its reader of glTF always name are left empty: headsets, surroundings that surfaces mirror, programs of materials that
// nothing here has, and what scene/glb.ts takes out of files before they are read: movements, skins, extensions of materials.
import type { Plugin } from "vite";

const EMPTY_PROGRAM = 'export const vertex = ""; export const fragment = "";';
const EMPTY_CHUNK = 'export default "";';
const emptyClasses = (folder: string, names: string[]) => names.map((name) => [`${folder}/${name}.js`, `export class ${name} {}`]);

// Parts of three/src by the end of their names, and what they are here.
const HERE: Record<string, string> = {
  "renderers/webxr/WebXRManager.js": `export class WebXRManager {
    enabled = false;
    isPresenting = false;
    addEventListener() {}
    removeEventListener() {}
    setAnimationLoop() {}
    getEnvironmentBlendMode() {}
    dispose() {}
  }`,
  "renderers/webgl/WebGLEnvironments.js": "export class WebGLEnvironments { get(map) { return map; } dispose() {} }",
  "renderers/webgl/WebGLUniformsGroups.js": "export function WebGLUniformsGroups() { return { bind() {}, update() {}, dispose() {} }; }",
  "loaders/FileLoader.js": "export class FileLoader { setPath() {} setRequestHeader() {} setPriority() {} setCache() {} setResponseType() {} setWithCredentials() {} }",
  "animation/PropertyBinding.js": 'export class PropertyBinding { static sanitizeNodeName(name) { return name.replace(/[\\s.:/[\\]]/g, "_"); } }',
  ...Object.fromEntries([
    ...emptyClasses("animation", ["AnimationClip", "KeyframeTrack"]),
    ...emptyClasses("cameras", ["CubeCamera"]),
    ...emptyClasses("objects", ["SkinnedMesh", "Skeleton"]),
    ...emptyClasses("materials", ["MeshPhysicalMaterial"]),
    ...["backgroundCube", "cube", "distance", "equirect", "linedashed", "meshmatcap", "meshnormal", "meshphong", "meshtoon", "points", "sprite", "vsm"].map(
      (name) => [`renderers/shaders/ShaderLib/${name}.glsl.js`, EMPTY_PROGRAM],
    ),
  ]),
};

// Chunks of programs that are for none of the materials here; each stands between #if and #endif.
const CHUNKS = /\/ShaderChunk\/(?:batching|bumpmap|clipping_planes|displacementmap|envmap|fog|iridescence|lightmap|lightprobes|lights_phong|lights_toon|logdepthbuf|skin|transmission)\w*\.glsl\.js$/;

// Programs without remarks and layout; lines that begin with # stay lines.
function tightened(program: string): string {
  return program
    .replace(/\/\*[^]*?\*\/|\/\/.*/g, "")
    .replace(/[ \t]*\n\s*/g, "\n")
    .replace(/^(?!\s*#)(?!export)(.*)$/gm, (line) => line.replace(/\s*([=+\-*/<>,;(){}&|?:])\s*/g, "$1"));
}

export function leanThree(): Plugin {
  return {
    name: "lean-three",
    enforce: "pre",
    config: () => ({ resolve: { alias: [{ find: /^three$/, replacement: "three/src/Three.js" }] } }),
    load(id) {
      if (!id.includes("/three/src/")) return null;
      return CHUNKS.test(id) ? EMPTY_CHUNK : (Object.entries(HERE).find(([end]) => id.endsWith(`/${end}`))?.[1] ?? null);
    },
    transform(code, id) {
      if (!id.endsWith(".glsl.js") || code === EMPTY_PROGRAM) return null;
      return { code: code.replace(/`[^`]*`/g, tightened), map: null };
    },
  };
}

// Files dropped onto the 3D view: they are saved beside the program, and an object with the mesh is added under the pointer.
import type { Editor } from "../editor/editor.ts";
import { nameForObject, objectText, placeForObject } from "../editor/new_object.ts";
import { el } from "../dom/dom.ts";
import { Refused } from "../home/connection.ts";
import type { MeshConverter } from "../home/converter.ts";
import type { SceneView } from "../scene/scene.ts";
import type { Intents } from "../store/intents.ts";
import { inControl, shownRun } from "../store/state.ts";
import type { Store } from "../store/store.ts";

const MOST_BYTES = 32 * 2 ** 20; // the limit of the laboratory
const MOST_FILES = 16; // at once
const MANY_METRES = 10;
const COMPANION = /\.(mtl|png|jpe?g|bin)$/i;

export function droppedFiles(stage: HTMLElement, scene: SceneView, store: Store, intents: Intents, editor: Editor, converter: MeshConverter | null): void {
  const holds = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  const over = (event: DragEvent) => {
    if (!holds(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = intents.live && inControl(store.state) ? "copy" : "none";
    stage.classList.add("takes");
  };
  stage.addEventListener("dragenter", over);
  stage.addEventListener("dragover", over);
  stage.addEventListener("dragleave", () => stage.classList.remove("takes"));
  stage.addEventListener("drop", (event) => {
    stage.classList.remove("takes");
    if (!holds(event)) return;
    event.preventDefault();
    // Materials and pictures precede the meshes that name them.
    const files = [...event.dataTransfer!.files].sort((a, b) => Number(COMPANION.test(b.name)) - Number(COMPANION.test(a.name))).slice(0, MOST_FILES);
    const { clientX, clientY } = event;
    void (async () => {
      for (const file of files) await take(file, { clientX, clientY });
    })();
  });

  async function take(file: File, pointer: { clientX: number; clientY: number }): Promise<void> {
    if (!intents.live) return intents.say("This is a recording: nothing can be put into it.");
    if (!inControl(store.state)) return intents.say("Only the page in control can put something into the program.");
    if (file.size > MOST_BYTES) return intents.say(`${file.name} has ${(file.size / 2 ** 20).toFixed(0)} MB; files of up to 32 MB are taken.`);
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const mesh = converter ? await converter.take(file.name, bytes) : { name: file.name, bytes };
      if (!mesh) return;
      const { name: kept, size: written } = await intents.keepFile(mesh.name, mesh.bytes);
      if (kept === "") return;
      const largest = Math.max(...written);
      const scale = largest > MANY_METRES ? await askForUnit(file.name, largest) : 1;
      if (scale === null) return;
      const size = written.map((each) => each * scale);
      const { text } = store.state;
      const found = scene.pointer.pointAt(pointer);
      const at = found ? found.at.toArray() : [0, 0, 0];
      // The frame of a mesh is in the middle of its bounding box.
      const height = Math.max(at[2]!, 0) + size[2]! / 2;
      const words = Object.values(store.state.welcome?.words ?? {}).flat();
      const things = shownRun(store.state)?.objects.map((object) => object.name) ?? [];
      const name = nameForObject(kept, text, [...words, ...things]);
      editor.insertLines(...lines(text, objectText(name, kept, [at[0]!, at[1]!, height], scale)));
      const widest = Math.max(...size);
      if (widest < 1e-3) intents.say(`${kept} is ${(1000 * widest).toFixed(3)} mm large: where a file does not say what its lengths are, they are taken for metres.`);
    } catch (error) {
      intents.say(error instanceof Refused || error instanceof Error ? `${file.name}: ${error.message}` : `${file.name} cannot be read.`);
    }
  }
}

// Many files do not say what their lengths are, and parts are drawn in millimetres: more than ten metres are doubtful. Returns the scale
// of the lengths; null: the file shall not be used.
function askForUnit(name: string, size: number): Promise<number | null> {
  return new Promise((resolve) => {
    let scale: number | null = null;
    const choose = (chosen: number | null) => () => {
      scale = chosen;
      dialog.close();
    };
    const length = (metres: number) => (metres < 1 ? `${+(1000 * metres).toPrecision(3)} mm` : `${+metres.toPrecision(3)} m`);
    const dialog: HTMLDialogElement = el(
      "dialog", { class: "help ask", "aria-label": "Unit of lengths" },
      el("p", {}, `${name} would be ${length(size)} large. Are its lengths in millimetres?`),
      el("div", { class: "row" },
        el("button", { onclick: choose(0.001) }, `Millimetres: ${length(size / 1000)}`),
        el("button", { onclick: choose(1) }, `Metres: ${length(size)}`),
        el("button", { onclick: choose(null) }, "Leave it out")),
    );
    dialog.addEventListener("close", () => {
      dialog.remove();
      resolve(scale);
    });
    document.body.append(dialog);
    dialog.showModal();
  });
}

// The offset for the new lines, and the lines.
function lines(text: string, object: string): [number, string] {
  const at = placeForObject(text);
  return [at, at > 0 && text[at - 1] !== "\n" ? `\n${object}` : object];
}

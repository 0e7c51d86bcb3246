// The 3D view as a video: the browser records the canvas while the run plays from start to end.
import { el, save, setText } from "../dom/dom.ts";
import type { Intents } from "../store/intents.ts";
import type { Store } from "../store/store.ts";

const PICTURES = 30; // a second, at most
const LAST = 250; // ms for which the last picture is shown

// The first video format that this browser can write; null: none.
function kindOfFilm(canvas: HTMLCanvasElement): string | null {
  if (typeof MediaRecorder === "undefined" || typeof canvas.captureStream !== "function") return null;
  return ["video/webm;codecs=vp9", "video/webm", "video/mp4"].find((kind) => MediaRecorder.isTypeSupported(kind)) ?? null;
}

export function videoButton(canvas: HTMLCanvasElement, store: Store, intents: Intents): HTMLButtonElement {
  const kind = kindOfFilm(canvas);
  let recorder: MediaRecorder | null = null;
  const start = () => {
    const stream = canvas.captureStream(PICTURES);
    const film: Blob[] = [];
    const own = (recorder = new MediaRecorder(stream, { mimeType: kind! }));
    own.addEventListener("dataavailable", (event) => event.data.size && film.push(event.data));
    own.addEventListener("stop", () => {
      for (const track of stream.getTracks()) track.stop();
      recorder = null;
      setText(button, "Video");
      button.setAttribute("aria-pressed", "false");
      if (film.length) save(kind!.includes("mp4") ? "view.mp4" : "view.webm", new Blob(film, { type: kind!.split(";")[0]! }));
    });
    setText(button, "Recording …");
    button.setAttribute("aria-pressed", "true");
    own.start();
    intents.goTo(0);
    intents.play(true);
    if (!store.state.playing) own.stop(); // a run without duration
  };
  const button: HTMLButtonElement = el("button", {
    class: "tiny", hidden: kind === null, "aria-pressed": "false", title: "Play the run and save it as a film; press again to end sooner",
    onclick: () => (recorder ? intents.play(false) : start()),
  }, "Video");
  // Pausing, going to another instant, or the end of the run ends the video.
  store.watch((s) => [s.playing], (s) => {
    const own = recorder;
    if (!s.playing && own?.state === "recording") setTimeout(() => own.state === "recording" && own.stop(), LAST);
  });
  return button;
}

// Starts the page: the store, the connection to the laboratory, the views, the clock for playing.
import { Connection } from "./home/connection.ts";
import { findHome } from "./home/home.ts";
import { takeSource } from "./home/source.ts";
import { buildPage } from "./shell/page.ts";
import "./shell/styles.css";
import { Intents } from "./store/intents.ts";
import { receive, receiveRows } from "./store/receive.ts";
import { Store } from "./store/store.ts";

const store = new Store((work) => requestAnimationFrame(work));
const source = takeSource();
const home = findHome();
let intents: Intents | undefined;

const connection = new Connection(home.carry, {
  opened: () => store.change((s) => (s.connectionNote = "")),
  lost: (note) => store.change((s) => {
    s.connection = "lost";
    s.connectionNote = note;
    s.playing = false;
  }),
  message: (message) => {
    store.change((s) => receive(s, message));
    intents?.heard(message);
  },
  rows: (block) => store.change((s) => receiveRows(s, block)),
});
intents = new Intents(store, connection, home.live);
buildPage(document.getElementById("page")!, store, intents, source, home.alone);

// The clock decides, however many frames are drawn. A hidden page draws none: it goes on where it was.
let last = 0;
document.addEventListener("visibilitychange", () => (last = performance.now()));
function frame(now: number): void {
  if (store.state.playing) {
    intents!.advance((now - last) / 1000);
    requestAnimationFrame(frame);
  }
  last = now;
}
store.watch((s) => [s.playing], (s) => {
  if (!s.playing) return;
  last = performance.now();
  requestAnimationFrame(frame);
});

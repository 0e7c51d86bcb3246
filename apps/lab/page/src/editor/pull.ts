// A number changes when it is dragged with Alt, with Alt and the wheel, or with Alt and page up or down; with fingers, by buttons beside
// it.
import { StateField, Transaction, type EditorState, type Extension } from "@codemirror/state";
import { EditorView, keymap, showTooltip, type Tooltip } from "@codemirror/view";
import { numberAt, pulled } from "./numbers.ts";

const PIXELS = 4; // of the pointer for one step

interface Pulling {
  from: number;
  text: string;
  now: string;
  x: number;
}

// `pulledText` is called after each change with the text and the offset of the number, `ended` when the number is released.
export function numberPulling(pulledText: (text: string, place: number) => void, ended: () => void): Extension {
  let pulling: Pulling | null = null;
  const replace = (view: EditorView, from: number, old: string, text: string) => {
    if (old === text || view.state.readOnly) return;
    view.dispatch({ changes: { from, to: from + old.length, insert: text }, annotations: Transaction.userEvent.of("input.pull") });
    pulledText(view.state.doc.toString(), from);
  };
  const found = (view: EditorView, position: number | null) => {
    if (position === null) return null;
    const line = view.state.doc.lineAt(position);
    const number = numberAt(line.text, position - line.from);
    return number && { from: line.from + number.from, text: number.text };
  };
  const step = (view: EditorView, steps: number) => {
    const number = found(view, view.state.selection.main.head);
    if (!number) return false;
    replace(view, number.from, number.text, pulled(number.text, steps));
    ended();
    return true;
  };
  const handlers = EditorView.domEventHandlers({
    pointerdown(event, view) {
      if (!event.altKey || event.button !== 0 || view.state.readOnly) return false;
      const number = found(view, view.posAtCoords({ x: event.clientX, y: event.clientY }));
      if (!number) return false;
      pulling = { ...number, now: number.text, x: event.clientX };
      const target = view.contentDOM;
      target.setPointerCapture(event.pointerId);
      event.preventDefault();
      return true;
    },
    mousedown: (event) => pulling !== null && event.altKey,
    pointermove(event, view) {
      if (!pulling) return false;
      const steps = Math.round((event.clientX - pulling.x) / PIXELS) * (event.shiftKey ? 10 : 1);
      const text = pulled(pulling.text, steps);
      replace(view, pulling.from, pulling.now, text);
      pulling.now = text;
      return true;
    },
    pointerup() {
      if (!pulling) return false;
      pulling = null;
      ended();
      return true;
    },
    wheel(event, view) {
      if (!event.altKey) return false;
      const number = found(view, view.posAtCoords({ x: event.clientX, y: event.clientY }));
      if (!number) return false;
      event.preventDefault();
      replace(view, number.from, number.text, pulled(number.text, (event.deltaY < 0 ? 1 : -1) * (event.shiftKey ? 10 : 1)));
      ended();
      return true;
    },
  });
  const keys = keymap.of([
    { key: "Alt-PageUp", run: (view) => step(view, 1), shift: (view) => step(view, 10) },
    { key: "Alt-PageDown", run: (view) => step(view, -1), shift: (view) => step(view, -10) },
  ]);
  return [handlers, keys, matchMedia("(pointer: coarse)").matches ? stepButtons(step) : []];
}

function stepButtons(step: (view: EditorView, steps: number) => boolean): Extension {
  const dom = (view: EditorView) => {
    const box = document.createElement("div");
    box.className = "number-steps";
    for (const [text, label, steps] of [["−", "Less", -1], ["+", "More", 1]] as const) {
      const button = document.createElement("button");
      button.textContent = text;
      button.setAttribute("aria-label", label);
      button.addEventListener("pointerdown", (event) => event.preventDefault()); // the cursor stays in the number
      button.addEventListener("click", () => step(view, steps));
      box.append(button);
    }
    return { dom: box };
  };
  const tooltipOf = (state: EditorState): Tooltip | null => {
    const { main } = state.selection;
    if (!main.empty || state.readOnly) return null;
    const line = state.doc.lineAt(main.head);
    const number = numberAt(line.text, main.head - line.from);
    return number && { pos: line.from + number.from, above: false, create: dom };
  };
  return StateField.define<Tooltip | null>({
    create: tooltipOf,
    update(value, transaction) {
      if (!transaction.docChanged && !transaction.selection) return value;
      const next = tooltipOf(transaction.state);
      return next && value && next.pos === value.pos ? value : next;
    },
    provide: (field) => showTooltip.from(field),
  });
}

// Lines that are too long go on below, indented by two characters more than their start.
import { Compartment, RangeSetBuilder, type Extension } from "@codemirror/state";
import { Decoration, EditorView, ViewPlugin, type DecorationSet, type ViewUpdate } from "@codemirror/view";
import { remember, remembered } from "../dom/dom.ts";

const MOST = 24; // characters of indentation

function hanging(view: EditorView): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  for (const { from, to } of view.visibleRanges) {
    for (let at = from; at <= to; ) {
      const line = view.state.doc.lineAt(at);
      const indent = Math.min(MOST, /^ */.exec(line.text)![0].length) + 2;
      builder.add(line.from, line.from, Decoration.line({ attributes: { style: `padding-left: calc(6px + ${indent}ch); text-indent: -${indent}ch` } }));
      at = line.to + 1;
    }
  }
  return builder.finish();
}

const indenting = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;
    constructor(view: EditorView) {
      this.decorations = hanging(view);
    }
    update(update: ViewUpdate): void {
      if (update.docChanged || update.viewportChanged) this.decorations = hanging(update.view);
    }
  },
  { decorations: (plugin) => plugin.decorations },
);

const wrapped = new Compartment();
const extension = (on: boolean): Extension => (on ? [EditorView.lineWrapping, indenting] : []);

export const wrapsLines = () => remembered("wrap") !== "no";

export function wrapping(): Extension {
  return wrapped.of(extension(wrapsLines()));
}

export function wrapLines(view: EditorView, on: boolean): void {
  remember("wrap", on ? "yes" : "no");
  view.dispatch({ effects: wrapped.reconfigure(extension(on)) });
}

// Marks of a run in the editor: breakpoints, the current line, the line under the pointer, and the duration of the moves of each
// line.
import { RangeSet, StateEffect, StateField, type Extension } from "@codemirror/state";
import { Decoration, EditorView, gutter, GutterMarker, type DecorationSet } from "@codemirror/view";

export interface Marks {
  breakpoints: number[];
  current: number | null;
  hovered: number | null;
  failed: number | null;
  // Texts beside lines: [line, text, longer text for the pointer].
  margin: [number, string, string][];
  stale: boolean;
}

export const setMarks = StateEffect.define<Marks>();

const none: Marks = { breakpoints: [], current: null, hovered: null, failed: null, margin: [], stale: false };

const marks = StateField.define<Marks>({
  create: () => none,
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(setMarks)) return effect.value;
    return value;
  },
  provide: (field) => EditorView.decorations.from(field, (value) => (view) => lines(view, value)),
});

function lines(view: EditorView, value: Marks): DecorationSet {
  const { doc } = view.state;
  const list: [number | null, string][] = [[value.hovered, "line-hovered"], [value.current, "line-current"], [value.failed, "line-failed"]];
  const ranges = list
    .filter(([line]) => line !== null && line >= 1 && line <= doc.lines)
    .map(([line, name]) => Decoration.line({ class: name }).range(doc.line(line!).from));
  return Decoration.set(ranges, true);
}

class Breakpoint extends GutterMarker {
  override toDOM(): HTMLElement {
    const dot = document.createElement("span");
    dot.className = "breakpoint";
    return dot;
  }
}

class Margin extends GutterMarker {
  private readonly text: string;
  private readonly title: string;
  constructor(text: string, title: string) {
    super();
    this.text = text;
    this.title = title;
  }
  override eq(other: GutterMarker): boolean {
    return other instanceof Margin && other.text === this.text && other.title === this.title;
  }
  override toDOM(): HTMLElement {
    const element = document.createElement("span");
    element.textContent = this.text;
    element.title = this.title;
    return element;
  }
}

const breakpoint = new Breakpoint();

function placed<T extends GutterMarker>(view: EditorView, items: [number, T][]): RangeSet<T> {
  const { doc } = view.state;
  return RangeSet.of(items.filter(([line]) => line >= 1 && line <= doc.lines).map(([line, marker]) => marker.range(doc.line(line).from)), true);
}

export function marking(toggle: (line: number) => void, hover: (line: number | null) => void): Extension {
  const lineAt = (view: EditorView, from: number) => view.state.doc.lineAt(from).number;
  return [
    marks,
    gutter({
      class: "gutter-breakpoints",
      renderEmptyElements: true,
      markers: (view) => placed(view, view.state.field(marks).breakpoints.map((line) => [line, breakpoint])),
      initialSpacer: () => breakpoint,
      domEventHandlers: {
        mousedown(view, block) {
          toggle(lineAt(view, block.from));
          return true;
        },
      },
    }),
    gutter({
      class: "gutter-margin",
      side: "after",
      markers: (view) => placed(view, view.state.field(marks).margin.map(([line, text, title]) => [line, new Margin(text, title)])),
    }),
    EditorView.editorAttributes.compute([marks], (state) => ({ class: state.field(marks).stale ? "stale" : "" })),
    EditorView.domEventHandlers({
      mousemove(event, view) {
        const position = view.posAtCoords({ x: event.clientX, y: event.clientY });
        hover(position === null ? null : lineAt(view, position));
      },
      mouseleave: () => hover(null),
    }),
  ];
}

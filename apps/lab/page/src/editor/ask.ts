// Completion, information under the pointer, and the signature of the call that is being written: questions to the laboratory.
import { acceptCompletion, autocompletion, completionStatus, moveCompletionSelection, selectedCompletionIndex, type Completion, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import { StateEffect, StateField, type Extension, type Text } from "@codemirror/state";
import { closeHoverTooltips, EditorView, hoverTooltip, showTooltip, ViewPlugin, type Tooltip, type ViewUpdate } from "@codemirror/view";
import type { IncomingOf, Position, Span } from "../protocol/messages.ts";
import type { Intents } from "../store/intents.ts";
import { settingAt } from "./settings.ts";

export function positionOf(doc: Text, offset: number): Position {
  const line = doc.lineAt(offset);
  return [line.number, offset - line.from];
}

export function offsetOf(doc: Text, [line, column]: Position): number {
  if (line < 1) return 0;
  if (line > doc.lines) return doc.length;
  const at = doc.line(line);
  return Math.min(at.to, at.from + Math.max(0, column));
}

export function rangeOf(doc: Text, span: Span): { from: number; to: number } {
  const from = offsetOf(doc, [span[0], span[1]]);
  return { from, to: Math.max(from, offsetOf(doc, [span[2], span[3]])) };
}

const KINDS: Record<string, string> = { method: "method", field: "property", variable: "variable", type: "type", keyword: "keyword", unit: "constant", function: "function" };

async function complete(intents: Intents, context: CompletionContext): Promise<CompletionResult | null> {
  const word = context.matchBefore(/[\w.]+/);
  if (!context.explicit && (!word || /^\d[\d_.]*$/.test(word.text))) return null;
  const answer = await intents.ask<"completion">({ type: "complete", at: positionOf(context.state.doc, context.pos) }).catch(() => null);
  if (!answer?.items.length || context.aborted) return null;
  const from = answer.replaced ? rangeOf(context.state.doc, answer.replaced).from : (context.matchBefore(/\w*/)?.from ?? context.pos);
  // Of equally good matches the editor would take the first of the alphabet: the order of the laboratory counts.
  const options = answer.items.map((item, i): Completion => ({
    label: item.text,
    boost: Math.max(-99, 99 - i),
    type: KINDS[item.kind ?? ""] ?? "variable",
    ...(item.detail ? { detail: item.detail } : {}),
  }));
  return { from, options, ...(answer.more ? {} : { validFor: /^\w*$/ }) };
}

// Tab inserts the selected completion, or the first one if none is selected.
export function takeFirst(view: EditorView): boolean {
  if (completionStatus(view.state) !== "active") return false;
  if (selectedCompletionIndex(view.state) === null) moveCompletionSelection(true)(view);
  return acceptCompletion(view);
}

function paragraph(className: string, text: string | null | undefined): HTMLElement[] {
  if (!text) return [];
  const element = document.createElement("div");
  element.className = className;
  element.textContent = text;
  return [element];
}

function hoverBox(answer: IncomingOf<"hover">): HTMLElement {
  const box = document.createElement("div");
  box.className = "tip";
  box.append(
    ...paragraph("tip-code", answer.text),
    ...paragraph("tip-value", answer.value ? `= ${answer.value}` : null),
    ...paragraph("tip-help", answer.help),
    ...(answer.messages ?? []).flatMap((message) => paragraph("tip-help", message)),
  );
  return box;
}

// The value at the shown instant of the name under the pointer. Another variable with that name has a declaration elsewhere.
async function valueAt(intents: Intents, at: Position): Promise<string | null> {
  const { instant, shown } = intents.state;
  if (!instant?.variables.length || instant.run !== shown) return null;
  const told = await intents.ask<"definition">({ type: "definition", at }).catch(() => null);
  return instant.variables.findLast(({ declared }) => declared && declared.join() === told?.span?.join())?.value ?? null;
}

function hovering(intents: Intents): Extension {
  return hoverTooltip(async (view, pos) => {
    const word = view.state.wordAt(pos);
    if (!word) return null;
    const at = positionOf(view.state.doc, pos);
    const answer = await intents.ask<"hover">({ type: "hover", at }).catch(() => null);
    if (!answer || (!answer.text && !answer.help)) return null;
    answer.value ||= await valueAt(intents, at);
    const range = answer.span ? rangeOf(view.state.doc, answer.span) : word;
    return { pos: range.from, end: range.to, above: true, create: () => ({ dom: hoverBox(answer) }) };
  }, { hoverTime: 250 });
}

// Text that moves under a resting pointer, by scrolling or a change, counts as pointed at: browsers report no pointer event
// then.
const resting = ViewPlugin.fromClass(
  class {
    private readonly view: EditorView;
    private last: MouseEvent | null = null;
    private under: Element | null = null;
    private timer: ReturnType<typeof setTimeout> | undefined;
    constructor(view: EditorView) {
      this.view = view;
    }
    rests(event: MouseEvent | null): void {
      if (event && !event.isTrusted) return;
      this.last = event?.buttons === 0 ? event : null;
      this.under = event?.target instanceof Element ? event.target : null;
    }
    update(): void {
      this.look();
    }
    look(): void {
      clearTimeout(this.timer);
      if (this.last) this.timer = setTimeout(() => this.tell(), 100);
    }
    destroy(): void {
      clearTimeout(this.timer);
    }
    private tell(): void {
      if (!this.last) return;
      const { clientX, clientY } = this.last;
      const now = document.elementFromPoint(clientX, clientY);
      if (!now || now === this.under || !this.view.contentDOM.contains(now)) return;
      this.under = now;
      this.view.dispatch({ effects: closeHoverTooltips });
      now.dispatchEvent(new MouseEvent("mousemove", { bubbles: true, clientX, clientY }));
    }
  },
  {
    eventHandlers: {
      mousemove(event) { this.rests(event); },
      mousedown() { this.rests(null); },
      mouseleave() { this.rests(null); },
      keydown() { this.rests(null); },
      scroll() { this.look(); },
    },
  },
);

const setCall = StateEffect.define<Tooltip | null>();
const call = StateField.define<Tooltip | null>({
  create: () => null,
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(setCall)) return effect.value;
    return value && transaction.docChanged ? { ...value, pos: transaction.changes.mapPos(value.pos) } : value;
  },
  provide: (field) => showTooltip.from(field),
});

function callBox(answer: IncomingOf<"signature">, setting: string | null): HTMLElement {
  const box = document.createElement("div");
  box.className = "tip";
  const overload = answer.overloads[answer.active ?? 0] ?? answer.overloads[0]!;
  const line = document.createElement("div");
  line.className = "tip-code";
  const named = setting === null ? undefined : overload.parameters.find((range) => overload.text.slice(...range).startsWith(`${setting}:`));
  const parameter = named ?? overload.parameters[answer.parameter ?? -1];
  if (parameter) {
    const strong = document.createElement("strong");
    strong.textContent = overload.text.slice(...parameter);
    line.append(overload.text.slice(0, parameter[0]), strong, overload.text.slice(parameter[1]));
  } else line.textContent = overload.text;
  box.append(line, ...paragraph("tip-help", overload.help));
  return box;
}

// ms: after this time the laboratory has received and checked the text with the last key.
const SIGNATURE_AFTER = 30;

function signatures(intents: Intents): Extension {
  const plugin = ViewPlugin.fromClass(
    class {
      private asked = 0;
      private timer: ReturnType<typeof setTimeout> | undefined;
      update(update: ViewUpdate): void {
        if (!update.docChanged && !(update.selectionSet && update.state.field(call))) return;
        const { state, view } = update;
        const typed = update.transactions.some((t) => t.isUserEvent("input.type") || t.isUserEvent("input.complete") || t.isUserEvent("delete"));
        if (!typed && !state.field(call)) return;
        this.asked++;
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.ask(view), SIGNATURE_AFTER);
      }
      destroy(): void {
        clearTimeout(this.timer);
      }
      private ask(view: EditorView): void {
        const at = view.state.selection.main.head;
        const asked = this.asked;
        void intents.ask<"signature">({ type: "signature", at: positionOf(view.state.doc, at) }).catch(() => null).then((answer) => {
          if (asked !== this.asked) return;
          const setting = settingAt(view.state.doc.sliceString(Math.max(0, at - 2000), at + 200), Math.min(at, 2000));
          const tooltip: Tooltip | null = answer?.overloads.length ? { pos: at, above: true, create: () => ({ dom: callBox(answer, setting) }) } : null;
          if (tooltip || view.state.field(call)) view.dispatch({ effects: setCall.of(tooltip) });
        });
      }
    },
  );
  return [call, plugin];
}

export function asking(intents: Intents): Extension {
  return [
    // Enter inserts a completion only if it was selected with the arrow keys; otherwise it ends the line.
    autocompletion({ override: [(context) => complete(intents, context)], activateOnTypingDelay: 80, selectOnOpen: false }),
    hovering(intents),
    resting,
    signatures(intents),
    EditorView.domEventHandlers({ keydown: (event, view) => event.key === "Escape" && view.state.field(call) !== null && (view.dispatch({ effects: setCall.of(null) }), true) }),
  ];
}

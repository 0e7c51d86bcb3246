// The page as a file: its HTML before anything was shown in it, with the data to be saved.

// Must be called when the page starts; a script that boot.ts has decompressed is in it in compressed form.
export function takeSource(): string {
  document.getElementById("armlet-code")?.remove();
  return `<!doctype html>\n${document.documentElement.outerHTML}`;
}

const PLACE = '<div id="page"></div>';

function carrying(page: string, attributes: string, json: unknown): string {
  const text = JSON.stringify(json).replaceAll("<", "\\u003c");
  return page.replace(PLACE, () => `${PLACE}<script type="application/json" ${attributes}>${text}</script>`);
}

function without(page: string, id: string): string {
  return page.replace(new RegExp(`<script[^>]*\\bid="${id}"[^>]*>[^]*?</script>`), "");
}

// A page that shows a recording; an engine in the page is left out.
export function pageWithRecording(page: string, recording: unknown): string {
  const bare = ["armlet-recording", "armlet-laboratory", "armlet-engine", "armlet-worker", "armlet-converter"].reduce(without, page);
  return carrying(bare, 'id="armlet-recording"', recording);
}

// A page with an engine and another laboratory.
export function pageWithLaboratory(page: string, laboratory: unknown): string {
  return carrying(without(page, "armlet-laboratory"), 'class="armlet-part" id="armlet-laboratory"', laboratory);
}

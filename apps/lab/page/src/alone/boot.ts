// Starts a page that stands alone: its script is packed in it, because a file is mailed and kept.
// The policy of the page names the hash of the script, so that nothing else can be put there.
import { unpacked } from "../protocol/packed.ts";

const packed = document.getElementById("armlet-page");
if (packed && "DecompressionStream" in window) {
  void new Response(unpacked(packed.textContent)).text().then((code) => {
    const script = document.createElement("script");
    script.type = "module";
    script.id = "armlet-code";
    script.textContent = code;
    document.body.append(script);
  });
} else {
  document.body.append("This laboratory needs a newer browser, of 2023 or later.");
}

// Starts a page without a server. Its script is compressed, because such a file is mailed and stored. The policy of the page contains the
// hash of the script, so that no other script can run.
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

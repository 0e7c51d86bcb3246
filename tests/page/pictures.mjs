// Makes the pictures of docs/images: the demonstration, light, dark and on a phone, arms of several kinds, and each example with a lab block.
import { mkdirSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { root } from "./modules.mjs";
import { closeBrowser, placeOf, untilStatus, withLab } from "./laboratory.mjs";

const images = join(root, "docs/images");

async function settled(page) {
  await untilStatus(page, /\d s$/);
  const hints = page.locator(".hint button:visible");
  while (await hints.count()) await hints.first().click();
  await page.mouse.move(2, 2);
  await page.waitForTimeout(400);
}

async function picture(name, text, options = {}, act = async () => {}) {
  await withLab(text, async (open) => {
    const page = await open({ viewport: { width: 1280, height: 800 }, ...options });
    await settled(page);
    await act(page);
    await page.waitForTimeout(400);
    await page.screenshot({ path: join(images, `${name}.png`) });
  });
  console.log(`${name}.png`);
}

async function half(page) {
  const bar = await page.locator(".bar").boundingBox();
  await page.mouse.click(bar.x + 0.47 * bar.width, bar.y + 40);
}


const wanted = process.argv.slice(2);
const make = async (name, ...rest) => (wanted.length && !wanted.includes(name) ? undefined : picture(name, ...rest));

mkdirSync(images, { recursive: true });
try {
  await make("lab_demo_light", null, { colorScheme: "light" }, half);
  await make("lab_demo_dark", null, { colorScheme: "dark" }, half);
  await make("lab_phone", null, { viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 }, half);
  await make("lab_pull", null, {}, async (page) => {
    const { x, y } = await placeOf(page, "let clearance", "80");
    await page.keyboard.down("Alt");
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 160, y, { steps: 8 });
    await page.waitForTimeout(1500);
  });
  await make("lab_handover", readFileSync(join(root, "examples/06_handover.rbt"), "utf8"), {}, half);
  for (const folder of ["examples/figures", "examples/labs", "examples"]) {
    for (const file of readdirSync(join(root, folder)).filter((name) => name.endsWith(".rbt"))) {
      const text = readFileSync(join(root, folder, file), "utf8");
      if (/^lab \w+ \{/m.test(text)) await make(`lab_${file.replace(".rbt", "")}`, text);
    }
  }
} finally {
  await closeBrowser();
}

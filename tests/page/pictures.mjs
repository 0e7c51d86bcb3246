// Makes the pictures of docs/images: the demonstration, light, dark and on a phone, arms of several kinds, the laboratory of the tutorial, and each example with a lab block.
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "./modules.mjs";
import { readPng, smallPng } from "./small_png.mjs";
import { boxGlb, gearGlb } from "./small_glb.mjs";
import { closeBrowser, placeOf, untilStatus, withLab, viewTool } from "./laboratory.mjs";

const images = join(root, "docs/images");

async function settled(page) {
  await untilStatus(page, /\d s$/);
  const hints = page.locator(".hint button:visible");
  while (await hints.count()) await hints.first().click();
  await page.mouse.move(2, 2);
  await page.waitForTimeout(400);
}

// files  beside the program; `part` of the page, all of it if empty; few  whether 256 colours suffice.
async function picture(name, text, { files = {}, part = "", few = false, ...options } = {}, act = async () => {}) {
  await withLab(text, async (open) => {
    const page = await open({ viewport: { width: 1280, height: 800 }, ...options });
    await settled(page);
    await act(page);
    await page.waitForTimeout(600);
    const taken = await (part ? page.locator(part) : page).screenshot();
    const { width, height, data } = few ? readPng(taken) : {};
    writeFileSync(join(images, `${name}.png`), few ? smallPng(width, height, data) : taken);
  }, files);
  console.log(`${name}.png`);
}

async function at(page, share) {
  const bar = await page.locator(".bar").boundingBox();
  await page.mouse.click(bar.x + share * bar.width, bar.y + 40);
  await page.mouse.move(2, 2);
}
const half = (page) => at(page, 0.47);

// The scenes of docs/world.md.
const stripes = (() => {
  const [width, height] = [96, 64];
  const data = new Uint8Array(3 * width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const isEdge = Math.min(x, y, width - 1 - x, height - 1 - y) < 6;
      const isArrow = Math.abs(y - height / 2) < (x < 56 ? 6 : Math.max(0, 78 - x)) && x > 18;
      data.set(isEdge || isArrow ? [255, 255, 255] : [0, 114, 178], 3 * (y * width + x));
    }
  }
  return smallPng(width, height, data);
})();
const world = { part: ".column.view", viewport: { width: 1500, height: 720 } };
const things = {
  "sign.glb": boxGlb([0.3, 0.012, 0.2], { picture: stripes }),
  "gear.glb": gearGlb(14, [0.075, 0.095], 0.03, [0.75, 0.35, 0.05]),
  "pinion.glb": gearGlb(8, [0.035, 0.053], 0.05, [0.1, 0.45, 0.3]),
};
const MESHES = `robot arm = robots.scara(tool: parallelGripper(stroke: 60mm, length: 100mm))
object plate { shape: box(500mm, 400mm, 40mm); at: xyz(420mm, 150mm, 20mm); color: "lightgray"; fixed: true }
object gear { shape: mesh("gear.glb", density: 2700kg/m^3); at: xyz(330mm, 150mm, 55mm) }
object pinion { shape: mesh("pinion.glb", density: 2700kg/m^3); at: xyz(480mm, 170mm, 65mm) * rotZ(12deg) }
object sign { shape: mesh("sign.glb"); at: xyz(250mm, -350mm, 150mm) * rotX(90deg) }
arm.moveJ(above(topGrasp(pinion), 80mm))
`;
const FRAMES = `robot arm = robots.scara()
object pallet { shape: box(300mm, 200mm, 20mm); at: xyz(350mm, 150mm, 10mm) * rotZ(30deg); color: "burlywood" }
frame corner { at: xyz(-150mm, -100mm, 10mm); on: pallet }
frame slot { at: xyz(160mm, 110mm); on: corner }
frame door { at: xyz(-250mm, 350mm, 0mm) }
arm.moveJ(posJ(10deg, 40deg, 0mm, 0deg), time: 1s)
`;
const FORCE = `robot arm = robots.scara(tool: tcp(xyz(z: 100mm)))
object ramp { shape: box(200mm, 200mm, 20mm); at: xyz(300mm, 200mm, 90mm) * rotY(-5deg); fixed: true; stiffness: 20N/mm }
arm.moveJ(xyz(300mm, 200mm, 150mm), time: 1s)
arm.moveL(xyz(300mm, 200mm, 60mm), speed: 20mm/s) until arm.force().z > 8N
wait(1s)
`;
const CLEARANCE = `robot left = robots.scara(base: xyz(0mm, 0mm, 0mm))
robot right = robots.scara(base: xyz(900mm, 0mm, 0mm) * rotZ(180deg))
object post { shape: box(60mm, 60mm, 380mm); at: xyz(350mm, 200mm, 190mm); fixed: true }
object block { shape: cylinder(radius: 50mm, height: 250mm); at: xyz(620mm, -330mm, 125mm); fixed: true }
left.moveJ(posJ(19deg, 40deg, 0mm, 0deg), time: 2s)
right.moveJ(posJ(60deg, -30deg, 120mm, 0deg), time: 2s)
`;

// The text of a program of a document, counted from 1.
function programOf(file, number) {
  return [...readFileSync(join(root, file), "utf8").matchAll(/```rbt\n(.*?)```/gs)][number - 1][1];
}

const wanted = process.argv.slice(2);
const make = async (name, ...rest) => (wanted.length && !wanted.includes(name) ? undefined : picture(name, ...rest));

mkdirSync(join(images, "cameras"), { recursive: true });
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
  await make("world_meshes", MESHES, { ...world, files: things });
  await make("world_frames", FRAMES, world);
  await make("world_force", FORCE, world);
  await make("world_clearance", CLEARANCE, world, async (page) => (await viewTool(page, "Clearance")).click());
  await make("world_way", readFileSync(join(root, "examples/22_around_a_wall.rbt"), "utf8"), world, (page) => at(page, 0.43));
  await make("lab_handover", readFileSync(join(root, "examples/06_handover.rbt"), "utf8"), {}, half);
  await make("cameras/window", readFileSync(join(root, "examples/24_camera_window.rbt"), "utf8"), { viewport: { width: 1280, height: 760 }, colorScheme: "light" }, (page) => at(page, 0.43));
  await make("tutorial/laboratory", programOf("docs/tutorial/07-a-laboratory.md", 2), { few: true, viewport: { width: 1060, height: 600 }, colorScheme: "light" }, async (page) => {
    await page.getByRole("button", { name: "To the right" }).click();
    await untilStatus(page, /6 moves/);
    await page.waitForTimeout(1500);
    await half(page);
  });
  for (const folder of ["examples/figures", "examples/figures/cameras", "examples/labs", "examples/cameras", "examples"]) {
    for (const file of readdirSync(join(root, folder)).filter((name) => name.endsWith(".rbt"))) {
      const text = readFileSync(join(root, folder, file), "utf8");
      if (/^lab \w+ \{/m.test(text)) await make(`lab_${file.replace(".rbt", "")}`, text);
    }
  }
} finally {
  await closeBrowser();
}

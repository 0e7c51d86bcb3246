// Shapes that are only shown in the 3D view, and what a description says of the shapes of links.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import test, { after } from "node:test";
import { BLUE, closeBrowser, goTo, GREEN, RED, shows, spotLike, until, untilStatus, viewTool, withLab } from "../laboratory.mjs";
import { boxGlb, twoColours } from "../small_glb.mjs";

after(closeBrowser);

// Pictures are kept where ARMLET_PICTURES says.
async function keep(page, name) {
  if (process.env.ARMLET_PICTURES) writeFileSync(join(process.env.ARMLET_PICTURES, `${name}.png`), await page.screenshot());
}

const SHAPES = `robot arm = robots.ur5()
object cube { shape: box(60mm, 60mm, 60mm); at: xyz(400mm, 300mm, 30mm) }
draw.arrow("force", xyz(), xyz(z: 300mm), on: arm, color: "#e00000", width: 20mm)
draw.capsule("zone", xyz(), xyz(z: 300mm), 80mm, on: cube, color: "#00c000")
draw.ellipsoid("reach", xyz(500mm, -300mm, 300mm), [200mm, 100mm, 60mm], color: "#0000e0")
draw.disk("goal", xyz(-300mm, 300mm, 2mm), 120mm, color: "#e0b000")
draw.line("edge", xyz(-400mm, -400mm, 0mm), xyz(400mm, -400mm, 0mm), color: "#7000c0", width: 15mm)
draw.text("note", "mind the gap", xyz(-300mm, 300mm, 100mm), color: "#e0b000", height: 60mm)
arm.moveJ(posJ(60deg, -90deg, 60deg, -60deg, -90deg, 0deg), time: 2s)
draw.clear()
wait(1s)
`;

test("shapes are drawn, go with what they are on, and are gone when they were taken away", () =>
  withLab(SHAPES, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await shows(page, "green", GREEN, 0, 60);
    assert.equal(await page.locator(".labels .label.drawn").count(), 0);
    await goTo(page, 0.05);
    await shows(page, "red", RED, 150);
    await shows(page, "green", GREEN, 150);
    await shows(page, "blue", BLUE, 150);
    const note = page.locator(".labels .label.drawn");
    await until(async () => (await note.count()) === 1 && (await note.textContent()) === "mind the gap", () => "the text is not shown");
    assert.equal(await note.evaluate((element) => getComputedStyle(element).color), "rgb(224, 176, 0)");
    const [arrow, zone] = [await spotLike(page, RED), await spotLike(page, GREEN)];
    await keep(page, "shapes_begin");
    await goTo(page, 0.6);
    await shows(page, "red", RED, 150);
    await keep(page, "shapes_later");
    const apart = (a, b) => Math.hypot(a.middle[0] - b.middle[0], a.middle[1] - b.middle[1]);
    let along = 0;
    await until(async () => (along = apart(arrow, await spotLike(page, RED))) > 20, () => `the arrow on the arm went ${along} pixels`);
    const still = apart(zone, await spotLike(page, GREEN));
    assert.ok(still < 5, `the capsule on the cube went ${still} pixels`);
  }));

const MANY = `robot arm = robots.scara()
for (k in range(30)) {
    for (i in range(1000)) {
        let at = xyz((i % 40) * 25mm - 500mm, floor(i / 40.0) * 25mm - 300mm, 0mm)
        draw.arrow(f"a{i}", at, at * xyz(z: 40mm + 30mm * sin(i * 0.1 + k * 0.2)), color: "#e00000", width: 5mm)
    }
    wait(33ms)
}
`;

test("a thousand arrows that change thirty times a second are drawn", () =>
  withLab(MANY, async (open) => {
    const page = await open();
    await untilStatus(page, /0\.99 s/);
    await shows(page, "red", RED, 1500);
    await keep(page, "many_arrows");
  }));

// A mesh with a red picture, a plain sphere, and a box for collisions that is larger than both.
const WITH_MESH = `<robot name="two">
  <link name="base"/>
  <link name="arm">
    <visual><origin xyz="0.25 0 0.3"/><geometry><mesh filename="plate.glb"/></geometry></visual>
    <visual><origin xyz="-0.3 0 0.3"/><geometry><sphere radius="0.12"/></geometry></visual>
    <collision><origin xyz="0 0 0.3"/><geometry><box size="1.0 0.4 0.4"/></geometry></collision>
  </link>
  <joint name="turn" type="revolute">
    <parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" velocity="1" effort="1"/>
  </joint>
</robot>
`;

test("a link is drawn as its visual shapes say, and as what collides when that is asked for", () =>
  withLab(`robot arm = urdf("two.urdf")\narm.moveJ(posJ(20deg), time: 1s)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await (await viewTool(page, "Fit")).click(); // the mesh comes later than the first picture
    await shows(page, "red", RED, 300);
    await keep(page, "mesh_and_sphere");
    await (await viewTool(page, "Solids")).click();
    await shows(page, "red", RED, 0, 20);
    await keep(page, "collision_shapes");
  }, { "two.urdf": WITH_MESH, "plate.glb": boxGlb([0.3, 0.05, 0.3], { picture: twoColours([230, 10, 10], [230, 10, 10]) }) }));

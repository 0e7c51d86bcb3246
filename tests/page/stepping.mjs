// Going through a program statement by statement: the same of a page that is served and of one in a file.
import { untilClock, untilStatus } from "./laboratory.mjs";

export const STEPS = `robot arm = robots.scara()
object cube { shape: box(40mm, 40mm, 40mm); at: xyz(300mm, 120mm, 20mm) }
fn go(a: angle) {
    arm.moveJ(posJ(a, 60deg, 50mm, 0deg), time: 1s)
}
var n = 1
go(10deg)
n = 2
go(20deg)
n = 3
`;

// Runs STEPS to a breakpoint, and on over, into and out of calls and back.
export async function stepThrough(page) {
  const current = (text) => page.locator(".line-current").filter({ hasText: text }).waitFor();
  const variable = (name, value) => page.locator(".variables tr", { hasText: name }).filter({ hasText: value }).waitFor();
  await untilStatus(page, /2 moves, 2\.00 s/);
  await page.getByRole("tab", { name: "Variables" }).click();
  await page.getByRole("button", { name: "To the start" }).click();
  await page.locator(".gutter-breakpoints .cm-gutterElement").nth(8).click();
  await page.locator(".breakpoint:visible").first().waitFor();
  await page.keyboard.press("F5");
  await current("n = 2");
  await untilClock(page, /^1\.00 /);
  await variable(/^n/, "1");
  await page.keyboard.press("F10");
  await current("go(20deg)");
  await page.keyboard.press("F11");
  await current("arm.moveJ");
  await variable(/^a/, "20 deg");
  await page.keyboard.press("Shift+F11");
  await current("n = 3");
  await page.keyboard.press("Shift+F10");
  await current("arm.moveJ");
  await untilClock(page, /^1\.00 /);
}

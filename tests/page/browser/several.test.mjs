// Several pages on one laboratory, and a connection that is lost.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { clock, closeBrowser, lineOf, ONE_MOVE, typeAtEnd, until, untilStatus, withLab } from "../laboratory.mjs";

after(closeBrowser);

const MORE = "arm.moveJ(posJ(0deg, 60deg, 50mm, 0deg), time: 1s)\n";

test("one page leads, the other follows; control is passed on", () =>
  withLab(ONE_MOVE, async (open) => {
    const teacher = await open();
    await untilStatus(teacher, /2\.00 s/);
    const student = await open();
    await untilStatus(student, /2\.00 s/);
    await student.getByText("You follow page 1.").waitFor();
    assert.equal(await student.getByRole("slider", { name: /^q1/ }).isDisabled(), true);
    await typeAtEnd(teacher, MORE);
    await untilStatus(student, /2 moves, 3\.00 s/);
    await teacher.getByRole("button", { name: "To the start" }).click();
    await until(async () => /^0\.00/.test(await clock(student).innerText()), () => "the student does not follow in time");
    await student.getByRole("button", { name: "Take control" }).click();
    await teacher.getByRole("button", { name: /Hand over to 2 \(asks\)/ }).click();
    await student.getByText("in control").waitFor();
    await typeAtEnd(student, MORE);
    await untilStatus(teacher, /3 moves, 4\.00 s/);
    await lineOf(teacher, "posJ(0deg").waitFor();
  }));

test("a page that follows says why typing has no effect, and how to take control", () =>
  withLab(ONE_MOVE, async (open) => {
    const teacher = await open();
    await untilStatus(teacher, /2\.00 s/);
    const student = await open({ acceptDownloads: true });
    await untilStatus(student, /2\.00 s/);
    await student.getByText("You follow page 1.").waitFor();
    assert.equal(await student.locator(".control.urged").count(), 0);
    await student.locator(".cm-content").focus();
    await student.keyboard.type("wait", { delay: 60 });
    await student.locator(".control.urged", { hasText: /What you type is not taken: ask for control, or go on in a copy/ }).waitFor();
    const [copy] = await Promise.all([student.waitForEvent("download"), student.getByRole("button", { name: "Save a copy" }).click()]);
    assert.equal(copy.suggestedFilename(), "program-copy.rbt");
    await student.getByRole("button", { name: "Take control" }).click();
    await teacher.getByRole("button", { name: "Hand over to 2 (asks)" }).click();
    await student.getByText("in control").waitFor();
    assert.equal(await student.locator(".control.urged").count(), 0);
  }));

test("people at a shared laboratory have names, which stay with their browsers", () =>
  withLab(ONE_MOVE, async (open) => {
    const teacher = await open();
    await untilStatus(teacher, /2\.00 s/);
    const student = await open();
    await untilStatus(student, /2\.00 s/);
    const name = (page) => page.getByRole("textbox", { name: "Your name, as others see it" });
    await name(teacher).fill("Ada");
    await name(teacher).press("Enter");
    await student.getByText("You follow Ada.").waitFor();
    await name(student).fill("Grace");
    await name(student).press("Enter");
    await teacher.getByRole("button", { name: "Hand over to Grace" }).waitFor();
    await student.getByRole("button", { name: "Take control" }).click();
    await teacher.getByRole("button", { name: "Hand over to Grace (asks)" }).click();
    await student.getByText("You are Grace, in control.").waitFor();
    await typeAtEnd(student, MORE);
    await untilStatus(teacher, /2 moves, 3\.00 s/);
    // The name stays with the browser.
    await teacher.reload();
    await student.getByRole("button", { name: "Hand over to Ada" }).waitFor();
  }));

test("a page whose connection was lost comes back to the present state", () =>
  withLab(ONE_MOVE, async (open) => {
    let sockets = [];
    const before = (page) => page.routeWebSocket(/live/, (socket) => {
      const server = socket.connectToServer();
      sockets.push({ socket, server });
    });
    const page = await open({ before });
    await untilStatus(page, /2\.00 s/);
    const other = await open();
    await untilStatus(other, /2\.00 s/);
    await sockets[0].server.close();
    await sockets[0].socket.close();
    await until(async () => sockets.length > 1, () => "the page does not connect again");
    await untilStatus(page, /1 move, 2\.00 s/);
    // Nobody was in control when it came back, so it is again.
    await until(async () => /in control/.test(await page.locator(".control").innerText()), () => "the page is not in control");
    await typeAtEnd(page, MORE);
    await untilStatus(other, /2 moves, 3\.00 s/);
    await untilStatus(page, /2 moves, 3\.00 s/);
  }));

// The file of a laboratory's program: saved by the page in control, and followed when it changes.

#include "program_file.hpp"

#include <doctest/doctest.h>

#include "lab_support.hpp"

using namespace armlet;
using namespace armlet::lab;

namespace {

const std::string kMove = "moveJ(posJ(20deg, 30deg, 10mm, 0deg), time: 1s)\n";
const std::string kOther = "moveJ(posJ(20deg, 30deg, 10mm, 0deg), time: 2s)\n";

// A file in memory, and how often it was written.
struct Disk {
  std::string text{};
  bool exists = true;
  std::string fault{};  // of the next writes; empty: they succeed
  int written = 0;
};

LaboratoryOptions lab_on(Disk& disk, const std::string& text) {
  LaboratoryOptions options = lab_with(text);
  options.program_file = {.exists = disk.exists,
                          .read = [&disk]() -> Result<std::string> {
                            if (!disk.exists) return Error{"missing", "there is no such file"};
                            return disk.text;
                          },
                          .write = [&disk](const std::string& given) -> std::optional<Error> {
                            if (!disk.fault.empty()) return Error{"system", disk.fault};
                            disk = {.text = given, .written = disk.written + 1};
                            return std::nullopt;
                          }};
  return options;
}

TestJson save(TestPage& page, bool replaces = false) {
  return page.ask({{"type", "save"}, {"replaces", replaces}});
}

void edit(TestPage& page, const std::string& text, int version) {
  page.send({{"type", "text"}, {"text", text}, {"version", version}});
}

}  // namespace

TEST_CASE("a save writes the text of the page, and all pages learn that it is saved") {
  Disk disk{.text = kMove};
  Laboratory laboratory(lab_on(disk, kMove));
  TestPage page(laboratory);
  page.hello();
  TestPage other(laboratory);
  other.hello();
  edit(page, kOther, 1);
  CHECK(disk.text == kMove);
  CHECK(save(page)["type"] == "saved");
  CHECK(disk.text == kOther);
  other.take();
  CHECK(other.last("document") ==
        TestJson{{"type", "document"}, {"text", kOther}, {"exists", true}, {"changed", false}});
}

TEST_CASE("only the page in control may save") {
  Disk disk{.text = kMove};
  Laboratory laboratory(lab_on(disk, kMove));
  TestPage page(laboratory);
  page.hello();
  TestPage other(laboratory);
  other.hello();
  edit(page, kOther, 1);
  CHECK(save(other)["reason"] == "control");
  CHECK(save(other, true)["reason"] == "control");
  CHECK(disk.written == 0);
}

TEST_CASE("a laboratory without a file refuses to save and sends no document") {
  Laboratory laboratory(lab_with(kMove));
  TestPage page(laboratory);
  page.hello();
  CHECK(save(page)["reason"] == "refused");
  CHECK(page.last("document").is_null());
}

TEST_CASE("a change from outside becomes the text of a page without edits, and runs") {
  Disk disk{.text = kMove};
  Laboratory laboratory(lab_on(disk, kMove));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  disk.text = kOther;
  laboratory.look_at_file();
  finish_work(laboratory);
  page.take();
  CHECK(page.last("text")["text"] == kOther);
  CHECK(page.last("document")["changed"] == false);
  CHECK(page.last("run")["t_end"] == 2.0);
}

TEST_CASE("a change from outside leaves edits alone, and a save asks before it replaces the file") {
  Disk disk{.text = kMove};
  Laboratory laboratory(lab_on(disk, kMove));
  TestPage page(laboratory);
  page.hello();
  edit(page, kOther, 1);
  disk.text = "// from outside\n";
  SUBCASE("noticed before the save") {
    laboratory.look_at_file();
    page.take();
    CHECK(page.last("document")["changed"] == true);
  }
  SUBCASE("noticed by the save") {}
  CHECK(save(page)["reason"] == "changed");
  CHECK(disk.text == "// from outside\n");
  CHECK(laboratory.text() == kOther);
  SUBCASE("the page replaces it") {
    CHECK(save(page, true)["type"] == "saved");
    CHECK(disk.text == kOther);
  }
  SUBCASE("the page takes the file") {
    edit(page, "// from outside\n", 2);
    page.take();
    CHECK(page.last("document")["changed"] == false);
    CHECK(save(page)["type"] == "saved");
  }
}

TEST_CASE("a file that cannot be written keeps its text, and the page learns why") {
  Disk disk{.text = kMove, .fault = "the file is read-only"};
  Laboratory laboratory(lab_on(disk, kMove));
  TestPage page(laboratory);
  page.hello();
  edit(page, kOther, 1);
  const TestJson answer = save(page);
  CHECK(answer["reason"] == "refused");
  CHECK(answer["message"] == "program.rbt cannot be written: the file is read-only.");
  CHECK(disk.text == kMove);
  CHECK(page.last("document")["text"] == kMove);
}

TEST_CASE("a program without a file is unsaved until the first save") {
  Disk disk{.exists = false};
  Laboratory laboratory(lab_on(disk, kMove));
  TestPage page(laboratory);
  page.hello();
  page.take();
  CHECK(page.last("document")["exists"] == false);
  laboratory.look_at_file();
  CHECK(save(page)["type"] == "saved");
  CHECK(disk.text == kMove);
  disk.exists = false;  // another program removes it
  laboratory.look_at_file();
  page.take();
  CHECK(page.last("document")["exists"] == false);
}

TEST_CASE("a file that another program made meanwhile is not replaced without a question") {
  Disk disk{.exists = false};
  Laboratory laboratory(lab_on(disk, kMove));
  TestPage page(laboratory);
  page.hello();
  disk = {.text = "// from outside\n"};
  CHECK(save(page)["reason"] == "changed");
  CHECK(disk.text == "// from outside\n");
}

TEST_CASE("the line ends of the file stay, whichever the page sends") {
  Disk disk{.text = "// one\r\n// two\r\n"};
  Laboratory laboratory(lab_on(disk, disk.text));
  TestPage page(laboratory);
  page.hello();
  edit(page, "// one\n// three\n", 1);
  CHECK(save(page)["type"] == "saved");
  CHECK(disk.text == "// one\r\n// three\r\n");
  disk.text = "// four\r\n";
  laboratory.look_at_file();
  CHECK(laboratory.text() == "// four\r\n");
}

// The laboratory as the worker of a page calls it.

#include <doctest/doctest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

extern "C" {
int armlet_lab_open(const char* json, int size);
int armlet_lab_receive(const char* bytes, int size);
int armlet_lab_advance();
int armlet_lab_take();
const char* armlet_lab_bytes();
int armlet_lab_size();
const char* armlet_lab_fault();
}

namespace {

using WorkerJson = nlohmann::json;

WorkerJson saved(const std::string& text) {
  return {{"format", 1},
          {"version", ARMLET_VERSION},
          {"robot", "scara"},
          {"world", nullptr},
          {"file", "a.rbt"},
          {"text", text},
          {"demo", false},
          {"files", WorkerJson::object()},
          {"runs", WorkerJson::array()}};
}

int open_saved(const WorkerJson& laboratory) {
  const std::string json = laboratory.dump();
  return armlet_lab_open(json.data(), static_cast<int>(json.size()));
}

std::string fault_of(const WorkerJson& laboratory) {
  CHECK(open_saved(laboratory) == -1);
  return armlet_lab_fault();
}

// What the laboratory sends to a page that says hello, of one type, last.
WorkerJson told_last(const std::string& type) {
  const std::string hello = R"({"type": "hello", "protocol": 1})";
  REQUIRE(armlet_lab_receive(hello.data(), static_cast<int>(hello.size())) == 0);
  while (armlet_lab_advance() == 1) {
  }
  WorkerJson last;
  for (int kind = armlet_lab_take(); kind != 0; kind = armlet_lab_take()) {
    if (kind == 2) continue;
    WorkerJson told = WorkerJson::parse(
        std::string(armlet_lab_bytes(), static_cast<std::size_t>(armlet_lab_size())));
    if (told["type"] == type) last = std::move(told);
  }
  return last;
}

}  // namespace

TEST_CASE("worker: what is no exported laboratory is refused with the reason") {
  WorkerJson other = saved("wait(1s)\n");
  other["robot"] = "nobody";
  CHECK(fault_of(other).find("nobody") != std::string::npos);
  other = saved("wait(1s)\n");
  other["version"] = "0.0.7";
  CHECK(fault_of(other).find("made by Armlet 0.0.7") != std::string::npos);
  other = saved("wait(1s)\n");
  other.erase("files");
  CHECK(fault_of(other).find("no laboratory that was exported") != std::string::npos);
  CHECK(armlet_lab_open("{", 1) == -1);
}

TEST_CASE("worker: the world of an exported laboratory comes with it") {
  WorkerJson laboratory = saved("insertObj(\"peg\")\n");
  REQUIRE(open_saved(laboratory) == 0);
  CHECK(told_last("diagnostics")["runs"] == false);
  laboratory["world"] = {
      {"name", "small"},
      {"text", "object peg { shape: box(20mm, 20mm, 20mm); at: xyz(300mm, 0mm, 10mm) }\n"}};
  REQUIRE(open_saved(laboratory) == 0);
  CHECK(told_last("diagnostics")["runs"] == true);
  CHECK(told_last("description")["world"] == "small");
}

TEST_CASE("worker: a page in a browser speaks to a laboratory without a server") {
  REQUIRE(open_saved(saved("moveJ(posJ(20deg, 0deg, 0mm, 0deg), time: 1s)\n")) == 0);
  const std::string hello = R"({"type": "hello", "protocol": 1})";
  REQUIRE(armlet_lab_receive(hello.data(), static_cast<int>(hello.size())) == 0);
  int slices = 0;
  while (armlet_lab_advance() == 1) REQUIRE(++slices < 1000);
  int rows = 0;
  std::string state;
  for (int kind = armlet_lab_take(); kind != 0; kind = armlet_lab_take()) {
    const std::string_view bytes(armlet_lab_bytes(), static_cast<std::size_t>(armlet_lab_size()));
    if (kind == 2) {
      std::uint32_t head[6];
      std::memcpy(head, bytes.data(), sizeof head);
      if (head[0] == 1) rows += static_cast<int>(head[4]);
    } else {
      const auto message = nlohmann::json::parse(bytes);
      if (message["type"] == "run") state = message["state"];
    }
  }
  CHECK(state == "done");
  CHECK(rows == 101);
}

TEST_CASE("worker: a page that stands alone gets the picture of a camera as a served one does") {
  REQUIRE(open_saved(saved("camera eye { at: xyz(z: 1m) * rotX(180deg); size: [64, 48] }\n"
                           "lab cell { view window(of: eye) }\nwait(1s)\n")) == 0);
  CHECK(told_last("run")["state"] == "done");
  const std::string ask = R"({"type": "picture", "element": "window", "t": 0.5, "seq": 77})";
  REQUIRE(armlet_lab_receive(ask.data(), static_cast<int>(ask.size())) == 0);
  while (armlet_lab_advance() == 1) {
  }
  std::uint32_t head[6] = {};
  for (int kind = armlet_lab_take(); kind != 0; kind = armlet_lab_take()) {
    std::uint32_t each[6] = {};
    if (kind == 2) std::memcpy(each, armlet_lab_bytes(), sizeof each);
    if (each[0] != 8) continue;
    std::memcpy(head, each, sizeof head);
    CHECK(armlet_lab_size() == static_cast<int>(sizeof head + 64 * 48 * 3 + each[5]));
  }
  CHECK(head[1] == 77);
  CHECK(head[2] == 3);
  CHECK(head[3] == 64);
  CHECK(head[4] == 48);
}

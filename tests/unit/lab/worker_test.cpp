// The laboratory as the worker of a page calls it.

#include <doctest/doctest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

extern "C" {
int armlet_lab_open(const char* robot, const char* file, const char* text, const char* version,
                    int is_demo);
int armlet_lab_receive(const char* bytes, int size);
int armlet_lab_advance();
int armlet_lab_take();
const char* armlet_lab_bytes();
int armlet_lab_size();
const char* armlet_lab_fault();
}

TEST_CASE("worker: a page in a browser speaks to a laboratory without a server") {
  CHECK(armlet_lab_open("nobody", "a.rbt", "wait(1s)\n", "1", 0) == -1);
  CHECK(std::string(armlet_lab_fault()).find("nobody") != std::string::npos);
  REQUIRE(armlet_lab_open("scara", "a.rbt", "moveJ(posJ(20deg, 0deg, 0mm, 0deg), time: 1s)\n", "1",
                          0) == 0);
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

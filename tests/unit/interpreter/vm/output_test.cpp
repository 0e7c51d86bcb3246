#include "armlet/interpreter/output.hpp"

#include <doctest/doctest.h>

#include "armlet/interpreter/engine.hpp"
#include "vm_fixture.hpp"

using namespace armlet;

namespace {

// A device with room for so many bytes.
struct Device {
  std::size_t room;
  std::string written = {};

  std::string write(std::string_view text) {
    if (text.size() > room) return "No space left on device";
    room -= text.size();
    written += text;
    return {};
  }
};

RunResult print_to(Device& device, const char* text, RunLimits limits = {}) {
  VmOptions options;
  options.limits = limits;
  options.output = [&device](std::string_view piece) { return device.write(piece); };
  Vm vm(lang::compiled(text), std::move(options));
  return vm.run();
}

}  // namespace

TEST_CASE("an output is made of what gives nothing, or a reason") {
  std::string seen;
  const Output plain = [&seen](std::string_view text) { seen += text; };
  CHECK(plain("one").empty());
  const Output full = [](std::string_view) { return std::string("full"); };
  CHECK(full("two") == "full");
  CHECK(seen == "one");
  CHECK(!Output());
}

TEST_CASE("a program that prints to a full device fails and says why") {
  Device device{12};
  const RunResult result = print_to(device, "print(\"12345\")\nprint(\"12345\")\nprint(\"12345\")");
  REQUIRE(result.status == Progress::kFailed);
  CHECK(result.error->code == "R0626");
  CHECK(result.error->message.find("No space left on device") != std::string::npos);
  CHECK(device.written == "12345\n12345\n");
}

TEST_CASE("a full device can be caught as an error of the host") {
  Device device{6};
  const RunResult result = print_to(
      device,
      "var kind = \"\"\ntry { print(\"1234567\") } catch (e) { kind = e.kind }\nprint(kind)");
  CHECK(result.status == Progress::kDone);
  CHECK(device.written == "Host\n");
}

TEST_CASE("the limit of output ends the program and says so") {
  Device device{1'000'000};
  const RunResult result =
      print_to(device, "while (true) { print(\"grüße\") }", {.output_bytes = 100});
  REQUIRE(result.status == Progress::kFailed);
  CHECK(result.error->code == "R0626");
  CHECK(result.error->message == "the program printed more than 100 bytes");
  // What fits is there, and ends with a whole character.
  CHECK(device.written.size() <= 100);
  CHECK(device.written.size() > 90);
  CHECK((static_cast<unsigned char>(device.written.back()) & 0xC0U) != 0xC0U);
}

TEST_CASE("a long text is written in pieces, and can be stopped between them") {
  std::string written;
  VmOptions options;
  Vm* running = nullptr;
  options.output = [&](std::string_view piece) {
    written += piece;
    if (written.size() > 1'000'000) running->cancel();
  };
  const std::string text = "var s = \"0123456789\"\nfor (i in range(20)) { s += s }\nprint(s)";
  Vm vm(lang::compiled(text.c_str()), std::move(options));
  running = &vm;
  CHECK(vm.run().status == Progress::kCancelled);
  CHECK(written.size() < 4'000'000);
}

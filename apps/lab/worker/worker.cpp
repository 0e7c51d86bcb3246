// The laboratory for a worker of a page: functions of C that speak the messages of
// docs/lab-protocol.md. There is one laboratory and one page. Nothing here blocks; the worker calls
// armlet_lab_advance as long as it says that there is more to do, and takes messages in between.

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#else
#define EMSCRIPTEN_KEEPALIVE
#endif

#include <deque>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "armlet/model/catalog.hpp"
#include "laboratory.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kMostBytes = 1'000'000;

struct Home {
  std::unique_ptr<Laboratory> laboratory;
  int page = 0;
  std::deque<Message> messages;
  Message taken;
  std::string fault;
};

Home& home() {
  static Home all;
  return all;
}

// No exception reaches JavaScript: -1, and the reason is kept.
template <class F>
int guarded(F f) {
  try {
    home().fault.clear();
    return f();
  } catch (const std::exception& error) {
    home().fault = error.what();
    return -1;
  }
}

}  // namespace
}  // namespace armlet::lab

using namespace armlet;
using namespace armlet::lab;

extern "C" {

// Begins a laboratory in place of the one before. The texts are UTF-8.
EMSCRIPTEN_KEEPALIVE int armlet_lab_open(const char* robot, const char* file, const char* text,
                                         const char* version, int is_demo) {
  return guarded([&] {
    LaboratoryOptions options;
    options.session.robot = make_robot(robot);
    if (options.session.robot == nullptr)
      throw ArgumentError("There is no robot \"" + std::string(robot) + "\".");
    options.session.default_world = table_world();
    options.file = file;
    options.text = text;
    options.version = version;
    options.is_demo = is_demo != 0;
    options.most_bytes = std::size_t{96} << 20U;
    home().messages.clear();
    home().laboratory = std::make_unique<Laboratory>(std::move(options));
    home().page = home().laboratory->join();
    return 0;
  });
}

// A message of the page.
EMSCRIPTEN_KEEPALIVE int armlet_lab_receive(const char* bytes, int size) {
  return guarded([&] {
    if (home().laboratory == nullptr) throw ArgumentError("There is no laboratory yet.");
    home().laboratory->receive(home().page, {bytes, static_cast<std::size_t>(size)});
    return 0;
  });
}

// Works for some milliseconds: 1 if there is more to do, otherwise 0.
EMSCRIPTEN_KEEPALIVE int armlet_lab_advance() {
  return guarded(
      [] { return home().laboratory != nullptr && home().laboratory->advance() ? 1 : 0; });
}

// Takes the next message for the page: 1 a text, 2 a binary one, 0 there is none. It stays where
// armlet_lab_bytes says until the next call.
EMSCRIPTEN_KEEPALIVE int armlet_lab_take() {
  return guarded([] {
    Home& all = home();
    if (all.laboratory != nullptr && all.messages.empty()) {
      for (Message& each : all.laboratory->take_messages(all.page, kMostBytes))
        all.messages.push_back(std::move(each));
    }
    if (all.messages.empty()) return 0;
    all.taken = std::move(all.messages.front());
    all.messages.pop_front();
    return all.taken.is_binary ? 2 : 1;
  });
}
EMSCRIPTEN_KEEPALIVE const char* armlet_lab_bytes() { return home().taken.bytes.data(); }
EMSCRIPTEN_KEEPALIVE int armlet_lab_size() { return static_cast<int>(home().taken.bytes.size()); }
// Why the last call gave -1.
EMSCRIPTEN_KEEPALIVE const char* armlet_lab_fault() { return home().fault.c_str(); }

}  // extern "C"

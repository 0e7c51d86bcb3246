// The laboratory for a worker of a page: C functions that exchange the messages of
// docs/lab-protocol.md. There is one laboratory and one page. No function blocks; the worker calls
// armlet_lab_advance while it returns that there is more to do, and takes messages in between.

#ifdef __EMSCRIPTEN__
#include <emscripten.h>

#include "core/bare/memory_files.hpp"
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
#include "armlet/stdlib/workspace.hpp"
#include "kept_file.hpp"
#include "laboratory.hpp"
#include "messages/saved_laboratory.hpp"

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

// No exception may reach JavaScript: the function returns -1, and the reason is stored.
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

// Stores the files of a laboratory in memory, instead of the files of the one before.
void take_files([[maybe_unused]] LaboratoryOptions& options,
                [[maybe_unused]] const SavedLaboratory& saved) {
#ifdef __EMSCRIPTEN__
  for (const std::string& path : memory_files::list("/")) memory_files::remove(path);
  for (const auto& [path, text] : saved.files) memory_files::put(path, text);
  options.session.load = imports_of(saved.file);
  options.session.folder = ".";
  options.keep_file = [](const std::string& name, std::string bytes) {
    return keep_beside(
        name, bytes,
        [](const std::string& each) {
          return NameInUse{.is_used = memory_files::get(each).has_value(),
                           .bytes = memory_files::get(each).value_or(std::string())};
        },
        [](const std::string& each, const std::string& content) {
          memory_files::put(each, content);
          return std::optional<Error>();
        });
  };
#endif
}

LaboratoryOptions options_of(SavedLaboratory saved) {
  LaboratoryOptions options;
  if (!saved.robot.empty()) {
    options.session.robot = make_robot(saved.robot);
    if (options.session.robot == nullptr)
      throw ArgumentError("There is no robot \"" + saved.robot + "\".");
  }
  options.session.world = saved.world;
  if (!saved.world) options.session.default_world = table_world();
  take_files(options, saved);
  options.file = std::move(saved.file);
  options.text = std::move(saved.text);
  options.version = ARMLET_VERSION;
  options.is_demo = saved.is_demo;
  options.most_bytes = std::size_t{96} << 20U;
  options.most_picture_bytes = std::size_t{48} << 20U;
  return options;
}

}  // namespace
}  // namespace armlet::lab

using namespace armlet;
using namespace armlet::lab;

extern "C" {

// Begins an exported laboratory, instead of the present one: `laboratory` of "exported".
EMSCRIPTEN_KEEPALIVE int armlet_lab_open(const char* json, int size) {
  return guarded([&] {
    Result<SavedLaboratory> saved =
        read_saved({json, static_cast<std::size_t>(size)}, ARMLET_VERSION);
    if (!saved.ok()) throw ArgumentError(saved.error().message);
    home().messages.clear();
    home().laboratory = std::make_unique<Laboratory>(options_of(std::move(saved).value()));
    home().page = home().laboratory->join();
    return 0;
  });
}

// Handles a message of the page.
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

// Takes the next message for the page: 1: a text, 2: binary, 0: there is none. Its bytes are at
// armlet_lab_bytes until the next call.
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
// Why the last call returned -1.
EMSCRIPTEN_KEEPALIVE const char* armlet_lab_fault() { return home().fault.c_str(); }

}  // extern "C"

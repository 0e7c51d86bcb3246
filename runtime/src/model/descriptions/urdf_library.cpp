// The only interface to urdfdom. Its library is loaded when the first robot description is read: it
// loads four more shared libraries, which would delay the start of all other programs.

#include "urdf_library.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>

#include <mutex>
#include <type_traits>

#include "armlet/core/platform.hpp"

namespace armlet {
namespace {

// Captures the messages of urdfdom, which it would print.
class Capture : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR || text.empty()) return;
    if (first_.empty()) first_ = text;
    if (owner_.empty()) owner_ = owner_in(text);
  }
  // The first message, and its link or joint: the library names it when it stops.
  std::string reason() const {
    if (first_.empty() || owner_.empty() || first_.find(owner_) != std::string::npos) return first_;
    return fmt::format("{} `{}`: {}", owner_kind_, owner_, first_);
  }

 private:
  // The name in "... for Link [upper]", "... for joint [elbow]" or "link 'upper'".
  std::string owner_in(std::string_view text) {
    for (const std::string_view word : {"oint [", "ink [", "oint '", "ink '"}) {
      const std::size_t at = text.find(word);
      if (at == std::string_view::npos) continue;
      const std::size_t from = at + word.size();
      const std::size_t end = text.find(word.back() == '[' ? ']' : '\'', from);
      if (end == std::string_view::npos || end == from) continue;
      owner_kind_ = word.starts_with("oint") ? "joint" : "link";
      return std::string(text.substr(from, end - from));
    }
    return {};
  }

  std::string first_, owner_, owner_kind_;
};

// urdf::parseURDF, and the message handler of console_bridge.
struct Library {
  std::shared_ptr<urdf::ModelInterface> (*parse)(const std::string&) = nullptr;
  void (*use_handler)(console_bridge::OutputHandler*) = nullptr;
  void (*restore_handler)() = nullptr;
  std::string missing;
};

const Library& library() {
  static const Library loaded = [] {
    Library found;
    const LoadedLibrary urdfdom(ARMLET_URDFDOM_LIBRARY);
    const auto find = [&](auto& function, const char* symbol) {
      using Function = std::remove_reference_t<decltype(function)>;
      function = reinterpret_cast<Function>(urdfdom.find(symbol));
      if (function == nullptr) found.missing = ARMLET_URDFDOM_LIBRARY;
    };
    find(found.parse, "_ZN4urdf9parseURDFERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE");
    find(found.use_handler, "_ZN14console_bridge16useOutputHandlerEPNS_13OutputHandlerE");
    find(found.restore_handler, "_ZN14console_bridge28restorePreviousOutputHandlerEv");
    return found;
  }();
  return loaded;
}

}  // namespace

// The handler of console_bridge is global to the process: only one text is parsed at a time.
ParsedUrdf parse_urdf(const std::string& text) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  ParsedUrdf parsed;
  if (!library().missing.empty()) {
    parsed.reason = fmt::format(
        "robot descriptions are read by the library {}, which is not installed (Debian: "
        "liburdfdom-model3.0)",
        library().missing);
    return parsed;
  }
  Capture capture;
  library().use_handler(&capture);
  try {
    parsed.model = library().parse(text);
  } catch (const std::exception& error) {
    parsed.reason = error.what();
  }
  library().restore_handler();
  if (!capture.reason().empty()) parsed.reason = capture.reason();
  return parsed;
}

}  // namespace armlet

// The functions of the module armlet.wasm for JavaScript: C functions whose texts are UTF-8,
// described in docs/wasm.md. No function blocks; a worker calls `armlet_run` with a small budget,
// takes the events, and calls it again.

#include <emscripten.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "armlet/backend/jsonl_backend.hpp"
#include "armlet/backend/run_hash.hpp"
#include "armlet/core/error.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "armlet/stdlib/workspace.hpp"
#include "core/bare/memory_files.hpp"

namespace armlet::wasm {
namespace {

// The results of functions; docs/wasm.md has those of armlet_run.
enum Answer : int { kDone = 0, kFailed = 1, kPaused = 2, kCancelled = 3, kMisused = -1 };

// The results of armlet_take. Each is emptied when it is taken, except the hash.
enum class What : int { kOutput, kMessages, kMessagesAsJson, kEvents, kHash };

// A session and its output since it was taken last.
class Seat {
 public:
  Seat(const std::string& robot, std::string folder, double steps, bool tells_events)
      : folder_(std::move(folder)) {
    SessionOptions options;
    options.robot = make_robot(robot);
    if (options.robot == nullptr) throw ArgumentError("There is no robot \"" + robot + "\".");
    options.default_world = table_world();
    options.folder = folder_;
    options.load = [this](const std::string& path, const std::string& from) {
      return imports_ ? imports_(path, from) : ImportedText{};
    };
    options.limits = limits(steps);
    options.output = [this](std::string_view text) { output_ += text; };
    options.advice = [this](const Diagnostic& d) { tell(d, session_->sources()); };
    options.backends.push_back(&hash_);
    if (tells_events) {
      events_backend_ = make_jsonl_backend(events_);
      options.backends.push_back(events_backend_.get());
    }
    session_ = std::make_unique<Session>(library_engine(), std::move(options));
  }

  bool compile(std::string text, const std::string& name) {
    imports_ = armlet::imports_of(name);
    const bool runs = session_->compile(std::move(text), name);
    for (const Problem& problem : session_->problems()) tell(problem.diagnostic, *problem.sources);
    return runs;
  }

  // Runs for this much virtual time, s, or this many steps.
  int run(double time, double steps) {
    if (!(time >= 0.0) || !(steps >= 1.0))
      throw ArgumentError("A slice has no negative time and at least 1 step.");
    Budget budget;
    const bool goes_on =
        session_->vm() != nullptr && session_->result().status == Progress::kPaused;
    const double now_ns = goes_on ? static_cast<double>(this->now_ns()) : 0.0;
    budget.until_ns = static_cast<std::int64_t>(
        std::min(now_ns + 1e9 * time, static_cast<double>(kEndOfTime_ns)));
    budget.steps = static_cast<std::uint64_t>(std::min(steps, 1e15));
    const Progress progress = session_->run(budget);
    if (progress == Progress::kPaused) return kPaused;
    if (const auto& error = session_->result().error) tell(*error, session_->sources());
    return progress == Progress::kDone     ? kDone
           : progress == Progress::kFailed ? kFailed
                                           : kCancelled;
  }

  // Virtual time of the run, ns.
  [[nodiscard]] std::int64_t now_ns() const {
    return session_->host() != nullptr ? session_->host()->now_ns() : 0;
  }

  std::string take(What what) {
    switch (what) {
      case What::kOutput:
        return std::exchange(output_, {});
      case What::kMessages:
        return std::exchange(messages_, {});
      case What::kMessagesAsJson:
        return std::exchange(messages_json_, {});
      case What::kHash:
        return hash_.text();
      case What::kEvents: {
        std::string events = events_.str();
        events_.str({});
        return events;
      }
    }
    throw ArgumentError("There is nothing of this kind to take.");
  }

  Session& session() { return *session_; }

 private:
  // The stacks of programs and their values share the memory of a page.
  static RunLimits limits(double steps) {
    RunLimits limits;
    limits.steps = static_cast<std::uint64_t>(std::clamp(steps, 1.0, 1e15));
    limits.heap_bytes = std::uint64_t{512} << 20U;
    return limits;
  }

  void tell(const Diagnostic& diagnostic, const SourceSet& sources) {
    messages_ += render_text(diagnostic, sources);
    messages_json_ += render_json(diagnostic, sources) + '\n';
  }

  std::string folder_;
  ModuleLoader imports_;
  std::string output_, messages_, messages_json_;
  RunHash hash_;
  std::ostringstream events_;
  std::unique_ptr<Backend> events_backend_;
  std::unique_ptr<Session> session_;
};

std::map<int, std::unique_ptr<Seat>> seats;
int last_seat = 0;
std::string taken;  // the text returned by the last call
std::string fault;  // why the last call was refused

Seat& seat_of(int session) {
  const auto found = seats.find(session);
  if (found == seats.end())
    throw ArgumentError("There is no session " + std::to_string(session) +
                        "; armlet_open gives their numbers, and armlet_close takes them back.");
  return *found->second;
}

// No exception may reach JavaScript.
template <class F>
int guarded(F f) {
  try {
    fault.clear();
    return f();
  } catch (const std::exception& error) {
    fault = error.what();
    return kMisused;
  }
}

const char* hand_out(std::string text) {
  taken = std::move(text);
  return taken.c_str();
}

}  // namespace
}  // namespace armlet::wasm

using namespace armlet;
using namespace armlet::wasm;

extern "C" {

EMSCRIPTEN_KEEPALIVE int armlet_open(const char* robot, const char* folder, double steps,
                                     int tells_events) {
  return guarded([&] {
    auto seat = std::make_unique<Seat>(robot, folder, steps, tells_events != 0);
    seats.emplace(++last_seat, std::move(seat));
    return last_seat;
  });
}

EMSCRIPTEN_KEEPALIVE int armlet_close(int session) {
  return guarded([&] {
    seat_of(session);
    seats.erase(session);
    return kDone;
  });
}

EMSCRIPTEN_KEEPALIVE int armlet_compile(int session, const char* text, const char* name) {
  return guarded([&] { return seat_of(session).compile(text, name) ? kDone : kFailed; });
}

EMSCRIPTEN_KEEPALIVE int armlet_run(int session, double time, double steps) {
  return guarded([&] { return seat_of(session).run(time, steps); });
}

EMSCRIPTEN_KEEPALIVE int armlet_cancel(int session) {
  return guarded([&] {
    seat_of(session).session().cancel();
    return kDone;
  });
}

// Virtual time, s.
EMSCRIPTEN_KEEPALIVE double armlet_time(int session) {
  double time = 0.0;
  guarded([&] {
    time = static_cast<double>(seat_of(session).now_ns()) / 1e9;
    return kDone;
  });
  return time;
}

// The text is valid until the next call of any function.
EMSCRIPTEN_KEEPALIVE const char* armlet_take(int session, int what) {
  std::string text;
  guarded([&] {
    text = seat_of(session).take(static_cast<What>(what));
    return kDone;
  });
  return hand_out(std::move(text));
}
EMSCRIPTEN_KEEPALIVE const char* armlet_taken() { return taken.data(); }
EMSCRIPTEN_KEEPALIVE int armlet_taken_bytes() { return static_cast<int>(taken.size()); }
EMSCRIPTEN_KEEPALIVE const char* armlet_error() { return fault.c_str(); }

EMSCRIPTEN_KEEPALIVE int armlet_put_file(const char* path, const char* bytes, int size) {
  return guarded([&] {
    memory_files::put(path, {bytes, static_cast<std::size_t>(size)});
    return kDone;
  });
}
// kFailed: there is no such file.
EMSCRIPTEN_KEEPALIVE int armlet_get_file(const char* path) {
  return guarded([&] {
    std::optional<std::string> content = memory_files::get(path);
    const bool found = content.has_value();
    hand_out(found ? *std::move(content) : std::string());
    return found ? kDone : kFailed;
  });
}
EMSCRIPTEN_KEEPALIVE int armlet_remove_file(const char* path) {
  return guarded([&] { return memory_files::remove(path) ? kDone : kFailed; });
}
// The paths, one per line.
EMSCRIPTEN_KEEPALIVE const char* armlet_list_files(const char* folder) {
  std::string lines;
  for (const std::string& path : memory_files::list(folder)) lines += path + '\n';
  return hand_out(std::move(lines));
}

}  // extern "C"

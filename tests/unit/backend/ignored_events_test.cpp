// What backends declare to ignore against what can be seen of what they do with it.
#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <optional>
#include <sstream>
#include <string>

#include "armlet/backend/fan_out.hpp"
#include "armlet/backend/recorder.hpp"
#include "armlet/backend/trace_format.hpp"

using namespace armlet;

namespace {

constexpr std::array kNumbers{0.1, 0.2, 0.3};
constexpr std::array<std::uint8_t, 3> kPixel{1, 2, 3};

// A run with one event of each kind; the robot that joins has more joints than those before it.
void play_without(std::optional<EventKind> left_out, Backend& backend) {
  const Figure figure{.title = "speed"};
  const std::span<const double> one(kNumbers.data(), 1);
  const Event events[] = {
      BeginRun{.run = {.robots = {{"arm", {{JointUnit::kRadian}}}}, .objects = {{.name = "cube"}}}},
      RobotAdded{.t_ns = 1, .robot = {"late", std::vector<JointInfo>(3)}},
      RobotChanged{.t_ns = 1, .robot = {"changed", {{JointUnit::kMetre}}}},
      JointSample{.t_ns = 2, .q = one, .qd = one, .qdd = one},
      ObjectAdded{.t_ns = 3, .object = {.name = "ball"}},
      ObjectSample{.t_ns = 4, .name = "ball"},
      ObjectEvent{.t_ns = 5, .name = "ball"},
      Note{.t_ns = 6, .text = "hello"},
      FigureChanged{.t_ns = 7, .figure = &figure},
      FinalFigure{.t_ns = 7, .figure = &figure},
      Undone{.t_ns = 7, .number = 10, .from = 3, .back_ns = 2},
      DrawingChanged{.t_ns = 8, .drawing = {.name = "force", .kind = "arrow"}},
      CameraAdded{.t_ns = 8, .camera = {.name = "eye"}},
      ImageFrame{.t_ns = 8, .camera = "eye", .width = 1, .height = 1, .pixels = kPixel},
      EndRun{.t_ns = 8},
  };
  static_assert(std::size(events) == kEventKinds);
  for (const Event& each : events) {
    // Without a beginning there is no robot to name.
    const bool nameless = left_out == EventKind::kBeginRun && kind_of(each) != EventKind::kEndRun;
    if (kind_of(each) != left_out && !nameless) backend.on(each);
  }
}

struct Seen {
  std::string content;
  EventKinds ignored{};
};
using SeenWithout = std::function<Seen(std::optional<EventKind>)>;

Seen recorded(const Recorder& recorder, const Backend& backend) {
  std::string content;
  for (const auto& each : recorder.run().robots) content += each.name + " ";
  for (const auto& each : recorder.joints()) content += std::to_string(each.t_ns) + " ";
  for (const auto& each : recorder.objects()) content += each.name + std::to_string(each.t_ns);
  for (const auto& each : recorder.events()) content += " event " + each.name;
  for (const auto& each : recorder.notes()) content += " note " + each.text;
  for (const auto& each : recorder.run().cameras) content += " camera " + each.name;
  for (const auto& each : recorder.frames()) content += " frame " + each.camera;
  for (const auto& each : recorder.undoings()) content += " from " + std::to_string(each.from);
  return {content + std::to_string(recorder.end_ns()), backend.ignores()};
}

Seen of_recorder(std::optional<EventKind> left_out) {
  Recorder recorder;
  play_without(left_out, recorder);
  return recorded(recorder, recorder);
}

Seen of_fan_out(std::optional<EventKind> left_out) {
  Recorder recorder;
  FanOut all({&recorder});
  play_without(left_out, all);
  return recorded(recorder, all);
}

void check_declaration(const std::string& name, const SeenWithout& run) {
  CAPTURE(name);
  const Seen whole = run({});
  for (std::size_t i = 0; i < kEventKinds; ++i) {
    const auto kind = static_cast<EventKind>(i);
    CAPTURE(to_text(kind));
    CHECK(whole.ignored.has(kind) == (run(kind).content == whole.content));
  }
}

}  // namespace

TEST_CASE("every format ignores what it declares to ignore, and nothing else") {
  for (const TraceFormat& format : trace_formats()) {
    check_declaration(std::string(format.ending), [&](std::optional<EventKind> left_out) -> Seen {
      std::ostringstream out;
      const std::unique_ptr<Backend> backend = format.make(out);
      play_without(left_out, *backend);
      return {out.str() + backend->error(), backend->ignores()};
    });
  }
}

TEST_CASE("so do a recorder, and several backends as one") {
  check_declaration("recorder", of_recorder);
  check_declaration("fan-out of a recorder", of_fan_out);
}

TEST_CASE("several backends ignore what each of them ignores") {
  Recorder recorder;
  std::ostringstream out;
  const auto lines = trace_format_of("run.jsonl")->make(out);
  const auto array = trace_format_of("run.npy")->make(out);
  CHECK(FanOut({&recorder, array.get()}).ignores() == (recorder.ignores() & array->ignores()));
  CHECK(FanOut({&recorder, lines.get()}).ignores() == EventKinds::of<FigureChanged>());
  CHECK(FanOut({}).ignores() == EventKinds::all());
}

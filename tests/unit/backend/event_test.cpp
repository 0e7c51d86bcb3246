#include "armlet/backend/event.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace armlet;

namespace {

// Handles notes and the end; what it ignores is the rest of what follows.
constexpr Ignore<BeginRun, RobotAdded, RobotChanged, JointSample, ObjectAdded, ObjectSample,
                 ObjectEvent, FigureChanged, FinalFigure, Undone, DrawingChanged, CameraAdded,
                 ImageFrame>
    kIgnored{};

std::string handled_as(const Event& event) {
  std::string handled = "ignored";
  std::visit(Overload{[&](const Note& note) { handled = note.text; },
                      [&](const EndRun&) { handled = "end"; }, kIgnored},
             event);
  return handled;
}

template <std::size_t... kIndex>
std::vector<Event> one_of_each(std::index_sequence<kIndex...>) {
  return {Event(std::in_place_index<kIndex>)...};
}

}  // namespace

TEST_CASE("kinds have words") {
  CHECK(to_text(ObjectChange::kAttached) == "attached");
  CHECK(to_text(ObjectChange::kDetached) == "detached");
  CHECK(to_text(ObjectChange::kRemoved) == "removed");
  CHECK(to_text(NoteKind::kOutput) == "output");
  CHECK(to_text(NoteKind::kMessage) == "message");
  CHECK(to_text(NoteKind::kAdvice) == "advice");
}

TEST_CASE("a kind is the struct that an event holds, and has its name") {
  CHECK(kind_of(BeginRun{}) == EventKind::kBeginRun);
  CHECK(kind_of(RobotAdded{}) == EventKind::kRobotAdded);
  CHECK(kind_of(RobotChanged{}) == EventKind::kRobotChanged);
  CHECK(kind_of(JointSample{}) == EventKind::kJointSample);
  CHECK(kind_of(ObjectAdded{}) == EventKind::kObjectAdded);
  CHECK(kind_of(ObjectSample{}) == EventKind::kObjectSample);
  CHECK(kind_of(ObjectEvent{}) == EventKind::kObjectEvent);
  CHECK(kind_of(Note{}) == EventKind::kNote);
  CHECK(kind_of(FigureChanged{}) == EventKind::kFigureChanged);
  CHECK(kind_of(FinalFigure{}) == EventKind::kFinalFigure);
  CHECK(kind_of(Undone{}) == EventKind::kUndone);
  CHECK(kind_of(EndRun{}) == EventKind::kEndRun);
  CHECK(kind_of(DrawingChanged{}) == EventKind::kDrawingChanged);
  CHECK(kind_of(CameraAdded{}) == EventKind::kCameraAdded);
  CHECK(kind_of(ImageFrame{}) == EventKind::kImageFrame);
  CHECK(to_text(EventKind::kJointSample) == "JointSample");
  std::set<std::string_view> names;
  for (const Event& each : one_of_each(std::make_index_sequence<kEventKinds>()))
    names.insert(to_text(kind_of(each)));
  CHECK(names.size() == kEventKinds);
  CHECK(names.count("") == 0);
}

TEST_CASE("every event has its time and its number") {
  CHECK(time_of(Note{.t_ns = 7, .number = 3}) == 7);
  CHECK(number_of(Note{.t_ns = 7, .number = 3}) == 3);
  CHECK(time_of(EndRun{.t_ns = -1}) == -1);
}

TEST_CASE("a set of kinds holds what it was made of") {
  constexpr EventKinds kKinds = EventKinds::of<Note, JointSample>();
  CHECK(kKinds.has(EventKind::kNote));
  CHECK(kKinds.has(EventKind::kJointSample));
  CHECK_FALSE(kKinds.has(EventKind::kObjectSample));
  CHECK((kKinds & EventKinds::of<Note, EndRun>()) == EventKinds::of<Note>());
  CHECK((kKinds & EventKinds::all()) == kKinds);
  for (const Event& each : one_of_each(std::make_index_sequence<kEventKinds>())) {
    CHECK(EventKinds::all().has(kind_of(each)));
    CHECK_FALSE(EventKinds().has(kind_of(each)));
  }
}

TEST_CASE("what an overload set handles is what it does not declare as ignored") {
  CHECK(handled_as(Note{.text = "hello"}) == "hello");
  CHECK(handled_as(EndRun{}) == "end");
  for (const Event& each : one_of_each(std::make_index_sequence<kEventKinds>())) {
    CAPTURE(to_text(kind_of(each)));
    CHECK((handled_as(each) == "ignored") == kIgnored.kinds().has(kind_of(each)));
  }
}

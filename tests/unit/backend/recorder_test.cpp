#include "armlet/backend/recorder.hpp"

#include <doctest/doctest.h>

#include "run.hpp"

using namespace armlet;

TEST_CASE("a recorder keeps everything in order") {
  Recorder recorder;
  play_short_run(recorder);
  CHECK(recorder.run().robots.size() == 3);
  REQUIRE(recorder.joints().size() == 1);
  CHECK(recorder.joints()[0].t_ns == 10000000);
  CHECK(recorder.joints()[0].qd == std::vector<double>{1.0 / 3.0, 2.5});
  CHECK(recorder.joints()[0].T_world_tool(2, 3) == 3.0);
  REQUIRE(recorder.objects().size() == 2);
  CHECK(recorder.objects()[1].name == "ball");
  REQUIRE(recorder.events().size() == 2);
  CHECK(recorder.events()[0].robot == 1);
  CHECK(recorder.events()[1].change == ObjectChange::kRemoved);
  REQUIRE(recorder.notes().size() == 2);
  CHECK(recorder.notes()[1].kind == NoteKind::kAdvice);
  CHECK(recorder.end_ns() == 3000000000);
}

TEST_CASE("equal runs are recorded equally, others not") {
  Recorder one, two;
  play_short_run(one);
  play_short_run(two);
  CHECK(one.same_as(two));
  two.on(Note{.t_ns = 1, .text = "more"});
  CHECK_FALSE(one.same_as(two));
}

#include "armlet/backend/fan_out.hpp"

#include <doctest/doctest.h>

#include "armlet/backend/recorder.hpp"
#include "armlet/core/error.hpp"
#include "run.hpp"

using namespace armlet;

namespace {

class Failing : public Backend {
 public:
  void on(const Event&) override {}
  [[nodiscard]] std::string error() const override { return "full"; }
};

}  // namespace

TEST_CASE("every backend hears the same") {
  Recorder alone, one, two;
  play_short_run(alone);
  FanOut both({&one, &two});
  play_short_run(both);
  CHECK(one.same_as(alone));
  CHECK(two.same_as(alone));
  CHECK(both.error().empty());
}

TEST_CASE("the poses of links are wanted if one backend wants them") {
  class Drawing : public Failing {
   public:
    [[nodiscard]] bool wants_link_poses() const override { return true; }
  };
  Recorder recorder;
  Failing failing;
  Drawing drawing;
  CHECK_FALSE(FanOut({&recorder, &failing}).wants_link_poses());
  CHECK(FanOut({&recorder, &drawing}).wants_link_poses());
}

TEST_CASE("the first error is the error of all") {
  Recorder fine;
  Failing failing;
  CHECK(FanOut({&fine, &failing}).error() == "full");
}

TEST_CASE("no backends are allowed, null ones are not") {
  FanOut nobody({});
  play_short_run(nobody);
  CHECK_THROWS_AS(FanOut({nullptr}), ArgumentError);
}

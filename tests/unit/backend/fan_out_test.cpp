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

TEST_CASE("every backend receives the same events") {
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

TEST_CASE("a backend that throws keeps the others from nothing") {
  class Throws : public Backend {
   public:
    explicit Throws(std::string why) : why_(std::move(why)) {}
    void on(const Event&) override { throw std::runtime_error(why_); }

   private:
    std::string why_;
  };
  Recorder alone, before, between, after;
  play_short_run(alone);
  Throws first("the first"), second("the second");
  FanOut all({&before, &first, &between, &second, &after});
  class Catches : public Backend {
   public:
    explicit Catches(Backend& backend) : backend_(backend) {}
    void on(const Event& event) override { CHECK_THROWS_WITH(backend_.on(event), "the first"); }

   private:
    Backend& backend_;
  } catches(all);
  play_short_run(catches);
  for (const Recorder* each : {&before, &between, &after}) CHECK(each->same_as(alone));
}

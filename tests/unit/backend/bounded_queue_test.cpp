#include "armlet/backend/bounded_queue.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "armlet/backend/npy_backend.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "run.hpp"

using namespace armlet;

namespace {

constexpr std::array kOne{1.0};

JointSample sample_of(int robot, int motion) {
  return {.robot = robot, .motion = motion, .q = kOne, .qd = kOne, .qdd = kOne};
}

// The numbers of what it receives.
class Listener : public Backend {
 public:
  void on(const Event& event) override { numbers.push_back(number_of(event)); }
  std::vector<std::uint64_t> numbers;
};

// The events of a run, and the numbers that a listener receives in any case.
struct Sent {
  std::uint64_t count = 0;
  std::set<std::uint64_t> must{};
};

// Sends a random run of two robots with motions, an object, figures and texts.
class RandomRun {
 public:
  RandomRun(std::uint64_t seed, Backend& backend) : random_(seed), backend_(backend) {}

  // between  called after every event.
  template <class Between>
  Sent send(int events, Between between) {
    sends(BeginRun{}, true);
    for (int i = 0; i < events; ++i) {
      step();
      between();
    }
    sends(FinalFigure{.figure = &figure_}, true);
    sends(EndRun{}, true);
    // The last of each is still there.
    for (const auto& [index, number] : figures_) sent_.must.insert(number);
    for (const auto& [robot, number] : last_of_motion_) sent_.must.insert(number);
    if (object_) sent_.must.insert(*object_);
    return sent_;
  }

 private:
  template <class T>
  std::uint64_t sends(T event, bool must) {
    event.number = sent_.count++;
    if (must) sent_.must.insert(event.number);
    backend_.on(event);
    return event.number;
  }

  void step() {
    const double what = random_.uniform(0, 1);
    const int robot = random_.uniform(0, 1) < 0.5 ? 0 : 1;
    if (what < 0.8) return sample(robot);
    if (what < 0.84) return begin_motion(robot);
    if (what < 0.93) {
      object_ = sends(ObjectSample{.name = "cube"}, false);
      return;
    }
    if (what < 0.95) {
      if (object_) sent_.must.insert(*object_);
      object_.reset();
      sends(ObjectEvent{.name = "cube"}, true);
      return;
    }
    if (what < 0.97) {
      figures_[robot] = sends(FigureChanged{.index = robot, .figure = &figure_}, false);
      return;
    }
    sends(Note{.text = "a text that is longer than a short string"}, true);
  }

  void begin_motion(int robot) {
    if (last_of_motion_.count(robot) != 0) sent_.must.insert(last_of_motion_[robot]);
    last_of_motion_.erase(robot);
    motion_[robot] = random_.uniform(0, 1) < 0.2 ? -1 : next_motion_++;
  }

  void sample(int robot) {
    const int motion = motion_.count(robot) == 0 ? -1 : motion_[robot];
    const bool is_first = last_of_motion_.count(robot) == 0;
    last_of_motion_[robot] = sends(sample_of(robot, motion), is_first || motion < 0);
  }

  Random random_;
  Backend& backend_;
  Figure figure_{.title = "speed"};
  Sent sent_;
  std::map<int, int> motion_;
  std::map<int, std::uint64_t> last_of_motion_, figures_;
  std::optional<std::uint64_t> object_;
  int next_motion_ = 0;
};

// Everything that has to be there is, in order, and the rest was counted.
void check_heard(const std::vector<std::uint64_t>& heard, const Sent& sent,
                 const Thinned& thinned) {
  CHECK(std::ranges::is_sorted(heard, std::less_equal<>()));
  const std::set<std::uint64_t> all(heard.begin(), heard.end());
  CHECK(std::ranges::includes(all, sent.must));
  CHECK(heard.size() + thinned.joint_samples + thinned.object_samples + thinned.figures ==
        sent.count);
}

}  // namespace

TEST_CASE("a queue that is never full hands over everything, in order") {
  Listener listener;
  BoundedQueue queue(listener, 1000);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    JointSample sample = sample_of(0, 0);
    sample.number = i;
    queue.on(sample);
  }
  CHECK(queue.size() == 1000);
  CHECK(queue.deliver() == 1000);
  CHECK(queue.size() == 0);
  CHECK(queue.take() == nullptr);
  CHECK(queue.thinned() == Thinned{});
  for (std::uint64_t i = 0; i < 1000; ++i) CHECK(listener.numbers[i] == i);
}

TEST_CASE(
    "of a full queue every second sample inside of a motion goes, beginning with the oldest") {
  Listener listener;
  BoundedQueue queue(listener, 8);
  for (std::uint64_t i = 0; i < 9; ++i) {
    JointSample sample = sample_of(0, 0);
    sample.number = i;
    queue.on(sample);
  }
  CHECK(queue.thinned() == Thinned{.joint_samples = 4});
  queue.deliver();
  CHECK(listener.numbers == std::vector<std::uint64_t>{0, 2, 4, 6, 8});
}

TEST_CASE("samples alone never make a queue longer than its capacity") {
  for (const std::size_t capacity : {2, 3, 10, 100}) {
    Listener listener;
    BoundedQueue queue(listener, capacity);
    std::size_t longest = 0;
    for (int i = 0; i < 2000; ++i) {
      queue.on(sample_of(0, 0));
      longest = std::max(longest, queue.size());
    }
    CHECK(longest <= std::max<std::size_t>(capacity, 2));
  }
}

TEST_CASE("texts stay, beyond the capacity, and samples around them still go") {
  Listener listener;
  BoundedQueue queue(listener, 10);
  for (int i = 0; i < 100; ++i) queue.on(Note{.text = "a text"});
  CHECK(queue.size() == 100);
  for (int i = 0; i < 1000; ++i) queue.on(sample_of(0, 0));
  CHECK(queue.size() < 100 * 8 / 7 + 4);
  CHECK(queue.thinned().joint_samples > 900);
}

TEST_CASE("a figure that was not taken is replaced by its next state, another figure is not") {
  Listener listener;
  BoundedQueue queue(listener, 100);
  Figure figure{.title = "one"};
  queue.on(FigureChanged{.number = 0, .index = 0, .figure = &figure});
  queue.on(FigureChanged{.number = 1, .index = 1, .figure = &figure});
  queue.on(FigureChanged{.number = 2, .index = 0, .figure = &figure});
  queue.deliver();
  queue.on(FigureChanged{.number = 3, .index = 0, .figure = &figure});
  queue.deliver();
  CHECK(listener.numbers == std::vector<std::uint64_t>{1, 2, 3});
  CHECK(queue.thinned() == Thinned{.figures = 1});
}

TEST_CASE("random runs lose nothing but what may go, and the same again if taken alike") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::vector<std::uint64_t> first;
    for (int again = 0; again < 2; ++again) {
      Random random(seed);
      const auto capacity = static_cast<std::size_t>(random.uniform(1, 60));
      const double taken = random.uniform(0, 1);
      Listener listener;
      BoundedQueue queue(listener, capacity);
      const Sent sent = RandomRun(seed, queue).send(400, [&] {
        if (random.uniform(0, 1) > taken) return;
        if (const auto event = queue.take()) listener.on(event->event());
      });
      queue.deliver();
      CHECK(queue.size() == 0);
      check_heard(listener.numbers, sent, queue.thinned());
      if (again == 0) first = listener.numbers;
      CHECK(listener.numbers == first);
    }
  }
}

TEST_CASE("a slow listener in another thread receives all that must be kept") {
  for (const std::size_t capacity : {4, 64}) {
    Listener listener;
    BoundedQueue queue(listener, capacity);
    std::atomic<int> worked = 0;
    std::thread slow([&] {
      while (queue.wait()) {
        for (int i = 0; i < 1'000; ++i) worked.fetch_add(1);  // slow without leaving the processor
        if (const auto event = queue.take()) listener.on(event->event());
      }
    });
    const Sent sent = RandomRun(capacity, queue).send(20'000, [] {});
    slow.join();
    check_heard(listener.numbers, sent, queue.thinned());
  }
}

TEST_CASE("waiting ends when the queue is closed, with what is left") {
  Listener listener;
  BoundedQueue queue(listener, 4);
  queue.on(Note{.text = "a text"});
  queue.close();
  CHECK(queue.wait());
  CHECK(queue.deliver() == 1);
  CHECK_FALSE(queue.wait());
}

TEST_CASE("what the listener ignores is not kept; the end is heard of all the same") {
  std::ostringstream out;
  const auto array = make_npy_backend(out);
  BoundedQueue queue(*array, 4);
  CHECK(queue.ignores() == array->ignores());
  queue.on(Note{.text = "a text"});
  CHECK(queue.size() == 0);

  class SamplesOnly : public Backend {
   public:
    void on(const Event&) override {}
    [[nodiscard]] EventKinds ignores() const override { return EventKinds::of<EndRun>(); }
    [[nodiscard]] bool wants_link_poses() const override { return true; }
    [[nodiscard]] std::string error() const override { return "full"; }
  } samples;
  BoundedQueue before(samples, 4);
  CHECK(before.wants_link_poses());
  CHECK(before.error() == "full");
  before.on(EndRun{});
  CHECK_FALSE(before.wait());
}

TEST_CASE("a trace behind a queue that is large enough has the same bytes") {
  std::ostringstream directly, behind;
  const auto one = make_npy_backend(directly), other = make_npy_backend(behind);
  play_short_run(*one);
  BoundedQueue queue(*other, 100);
  play_short_run(queue);
  queue.deliver();
  CHECK(behind.str() == directly.str());
}

TEST_CASE("a queue without room is refused") {
  Listener listener;
  CHECK_THROWS_AS(BoundedQueue(listener, 0), ArgumentError);
}

TEST_CASE(
    "of pictures that nobody takes every second goes, and the last one of each camera stays") {
  Listener listener;
  BoundedQueue queue(listener, 8);
  const std::vector<std::uint8_t> pixels(12);
  std::uint64_t number = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    for (const char* camera : {"eye", "ear"}) {
      queue.on(ImageFrame{.number = number++,
                          .camera = camera,
                          .frame = i,
                          .width = 2,
                          .height = 2,
                          .pixels = pixels});
    }
  }
  CHECK(queue.size() <= 8);
  CHECK(queue.size() + queue.thinned().frames == 200);
  queue.deliver();
  REQUIRE(listener.numbers.size() >= 2);
  CHECK(listener.numbers.back() == 199);
  CHECK(listener.numbers[listener.numbers.size() - 2] == 198);
  CHECK(std::ranges::is_sorted(listener.numbers));
}

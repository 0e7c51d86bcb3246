#pragma once
// The pages of a laboratory: which there are, who is in control, and what each has been told.

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "messages/write_message.hpp"

namespace armlet::lab {

// How much of a run a page knows.
struct KnownOfRun {
  std::uint64_t changes = 0;
  std::uint64_t described = 0;
  std::uint64_t figures = 0;
  std::size_t moves = 0, ways = 0, stretches = 0, lines = 0, events = 0, texts = 0, advice = 0,
              drawn = 0;
  std::vector<std::size_t> robots, objects, elements, forces, contacts, drawings;  // rows
};

// Counts of what there is to be told besides runs; a page that knows another count is told again.
struct Versions {
  std::uint64_t control = 0;
  std::uint64_t text = 0;
  std::uint64_t diagnostics = 0;
  std::uint64_t runs = 0;
  std::uint64_t shown = 0;
  std::uint64_t cursor = 0;
  std::uint64_t breakpoints = 0;
};

struct Page {
  int number = 0;
  std::string key;  // that nobody else knows
  bool is_greeted = false;
  std::deque<Message> answers;
  std::size_t answer_bytes = 0;
  Versions known;
  std::map<int, KnownOfRun> runs;  // by number
  std::set<int> wanted;            // runs that it has asked for
  // A file that it sends, as far as it has come.
  struct Sent {
    std::string name;
    std::string bytes;
  } sent;
};

class Pages {
 public:
  // Answers that may wait before a page is full.
  static constexpr std::size_t kMostAnswerBytes = 4'000'000;

  explicit Pages(int most) : most_(most) {}

  // -1: there are too many.
  int join();
  void leave(int page);
  [[nodiscard]] Page* find(int page);
  void answer(Page& page, Message message);
  void forget_run(int run);
  // Of the files that all of them have left.
  [[nodiscard]] std::size_t kept_bytes() const { return kept_bytes_; }
  void count_kept(std::size_t bytes) { kept_bytes_ += bytes; }

  // ---- control
  [[nodiscard]] bool is_holder(int page) const { return control_.holder == page; }
  // Shows it to the others; it has the control if nobody else has it, or if it knows the key of who
  // has: then it is the same page, which has been loaded again.
  void enter(int page, std::string_view key);
  // Takes it if nobody has it; otherwise the wish is kept until who has it gives it or leaves.
  // Whether it has it now.
  bool take(int page);
  // To nobody without a page. False: there is no such page.
  bool give(std::optional<int> page);
  [[nodiscard]] const ControlState& control() const { return control_; }
  [[nodiscard]] std::uint64_t control_changes() const { return changes_; }

 private:
  int most_;
  std::random_device chance_;
  int last_ = 0;
  std::size_t kept_bytes_ = 0;
  std::uint64_t changes_ = 1;
  std::map<int, Page> pages_;
  ControlState control_;
};

}  // namespace armlet::lab

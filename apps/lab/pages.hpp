#pragma once
// The pages of a laboratory, the page that has control, and the messages that each has received.

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

// The parts of a run that a page has received.
struct KnownOfRun {
  std::uint64_t changes = 0;
  std::uint64_t described = 0;
  std::uint64_t figures = 0;
  std::size_t moves = 0, ways = 0, stretches = 0, lines = 0, events = 0, texts = 0, advice = 0,
              drawn = 0;
  std::vector<std::size_t> robots, objects, elements, forces, contacts, drawings;  // row counts
};

// Counts of changes of data other than runs; a page with another count gets that data again.
struct Versions {
  std::uint64_t control = 0;
  std::uint64_t text = 0;
  std::uint64_t diagnostics = 0;
  std::uint64_t runs = 0;
  std::uint64_t shown = 0;
  std::uint64_t cursor = 0;
  std::uint64_t breakpoints = 0;
  std::uint64_t document = 0;
};

struct Page {
  int number = 0;
  std::string key;  // known only to this page
  bool is_greeted = false;
  std::deque<Message> answers;
  std::size_t answer_bytes = 0;
  Versions known;
  std::map<int, KnownOfRun> runs;  // by number
  std::set<int> wanted;            // runs that it has requested
  // The received part of a file that it sends.
  struct Sent {
    std::string name;
    std::string bytes;
  } sent;
};

class Pages {
 public:
  // Bytes of waiting answers from which on a page is full.
  static constexpr std::size_t kMostAnswerBytes = 4'000'000;

  explicit Pages(int most) : most_(most) {}

  // -1: there are too many pages.
  int join();
  void leave(int page);
  [[nodiscard]] Page* find(int page);
  void answer(Page& page, Message message);
  void forget_run(int run);
  // Bytes of saved files, also of pages that have left.
  [[nodiscard]] std::size_t kept_bytes() const { return kept_bytes_; }
  void count_kept(std::size_t bytes) { kept_bytes_ += bytes; }

  // ---- control
  [[nodiscard]] bool is_holder(int page) const { return control_.holder == page; }
  // Adds the page to the list that all pages show. It gets control if no page has it, or if its key
  // is that of the page with control: then it is the same page, reloaded.
  void enter(int page, std::string_view key);
  // Gets control if no page has it; otherwise the request waits until the page with control gives
  // it away or leaves. Returns whether it has control now.
  bool take(int page);
  // Empty: the page has no name.
  void set_name(int page, std::string name);
  // Without a page: no page has control. False: there is no such page.
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

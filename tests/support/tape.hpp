// The hash of each event of a run by its number. Events that are sent again, after going back,
// replace the first ones; undone events do not count until the run goes forward to them again.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "armlet/backend/run_hash.hpp"

namespace armlet {

class Tape : public Backend {
 public:
  void on(const Event& event) override {
    if (const auto* undone = std::get_if<Undone>(&event)) {
      if (undone->from > told_.size()) ++gaps_;
      hashes_ = told_;
      hashes_.resize(undone->from);
      return;
    }
    const std::uint64_t number = number_of(event);
    if (number > hashes_.size()) ++gaps_;
    RunHash one;
    one.on(event);
    for (auto* list : {&hashes_, &told_}) {
      list->resize(number);
      list->push_back(one.value());
    }
  }

  [[nodiscard]] const std::vector<std::uint64_t>& hashes() const { return hashes_; }
  // Events of an entry that was taken back no longer count, whether others come or not.
  void take_back(std::size_t before) {
    hashes_.resize(before);
    told_.resize(before);
  }
  // How often an event came without those before it.
  [[nodiscard]] int gaps() const { return gaps_; }

 private:
  std::vector<std::uint64_t> hashes_;
  std::vector<std::uint64_t> told_;  // with what is undone behind them
  int gaps_ = 0;
};

}  // namespace armlet

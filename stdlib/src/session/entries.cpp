// Entries of a session: each runs in the cell and with the variables that those before it have left.

#include <algorithm>
#include <utility>

#include "armlet/backend/fan_out.hpp"
#include "armlet/core/error.hpp"
#include "armlet/stdlib/session.hpp"

namespace armlet {

bool Session::submit(std::string text, std::string name) {
  if (is_running_.load() || is_under_way_) {
    throw ArgumentError(
        "A session takes the next entry when the one before has ended; run() or cancel it first.");
  }
  if (!is_entry_) {
    vm_.reset();
    is_entry_ = true;
  }
  CompileOptions options;
  options.is_entry = true;
  if (!entries_.empty()) options.after = entries_.back().program;
  entry_ = {.program = nullptr, .name = name, .text = text};
  return compile_as(std::move(text), std::move(name), options);
}

std::optional<EntryValue> Session::shown() const {
  return is_entry_ && vm_ != nullptr ? vm_->shown() : std::nullopt;
}

void Session::begin_entry() {
  entry_.program = compilation_.program;
  if (vm_ == nullptr) {
    begin_cell();
  } else {
    take_world();
    vm_->begin(entry_.program);
    result_ = vm_->result();
  }
  entry_.begin_ns = host_->now_ns();
  entry_.moves = static_cast<std::size_t>(host_->move_count());
  is_under_way_ = true;
}

// The machine gives back its variables after a failure; the cell comes about again.
void Session::end_entry() {
  is_under_way_ = false;
  can_run_ = false;  // an entry runs once
  if (result_.status == Progress::kDone) {
    entry_.end_ns = host_->now_ns();
    entry_.moves = static_cast<std::size_t>(host_->move_count()) - entry_.moves;
    entries_.push_back(std::exchange(entry_, {}));
    undone_.clear();
    return;
  }
  const RunResult failed = result_;
  const std::vector<Entry> kept = std::exchange(entries_, {});
  run_again(kept);
  result_ = failed;
}

void Session::run_again(std::span<const Entry> entries) {
  is_silent_ = true;
  vm_.reset();
  if (host_ != nullptr) host_->cell().set_backend(nullptr);
  for (const Entry& entry : entries) {
    compilation_.program = entry.program;
    if (vm_ == nullptr) {
      begin_cell();
    } else {
      take_world();
      vm_->begin(entry.program);
    }
    vm_->run(Budget{});
    come_to_rest(Budget{});
    entries_.push_back(entry);
  }
  is_silent_ = false;
  if (vm_ != nullptr) {
    result_ = vm_->result();
    listen();
  } else {
    host_ = nullptr;
  }
}

std::size_t Session::undo(std::size_t count) {
  if (is_running_.load() || is_under_way_)
    throw ArgumentError("An entry is under way; what is before it can be undone when it has ended.");
  count = std::min(count, entries_.size());
  if (count == 0) return 0;
  const auto first = entries_.end() - static_cast<std::ptrdiff_t>(count);
  undone_.insert(undone_.begin(), first, entries_.end());
  const std::vector<Entry> kept(entries_.begin(), first);
  entries_.clear();
  run_again(kept);
  return count;
}

std::size_t Session::redo(std::size_t count) {
  if (is_running_.load() || is_under_way_)
    throw ArgumentError("An entry is under way; what was undone can be done again when it has ended.");
  count = std::min(count, undone_.size());
  if (count == 0) return 0;
  std::vector<Entry> all = entries_;
  all.insert(all.end(), undone_.begin(), undone_.begin() + static_cast<std::ptrdiff_t>(count));
  undone_.erase(undone_.begin(), undone_.begin() + static_cast<std::ptrdiff_t>(count));
  entries_.clear();
  run_again(all);
  return count;
}

}  // namespace armlet

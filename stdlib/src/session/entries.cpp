// Entries of a session: each runs in the cell and with the variables that those before it have
// left.

#include <algorithm>
#include <utility>

#include "armlet/backend/fan_out.hpp"
#include "armlet/core/error.hpp"
#include "armlet/stdlib/session.hpp"
#include "replay/journal.hpp"

namespace armlet {

void Session::require_rest(std::string_view what) const {
  if (!is_running_.load() && !is_under_way_) return;
  throw ArgumentError("An entry is under way: " + std::string(what) +
                      " when it has ended. run() brings it to its end, cancel() stops it.");
}

bool Session::submit(std::string text, std::string name) {
  require_rest("the session takes the next one");
  if (!is_entry_) {
    forget_run();
    is_entry_ = true;
  }
  CompileOptions options;
  options.is_entry = true;
  options.after = newest_program();
  entry_ = {.program = nullptr, .name = name, .text = text};
  return compile_as(std::move(text), std::move(name), options);
}

std::shared_ptr<const Program> Session::newest_program() const {
  return done_ == 0 ? nullptr : log_[done_ - 1].program;
}

std::optional<EntryValue> Session::shown() const {
  return is_entry_ && vm_ != nullptr ? vm_->shown() : std::nullopt;
}

// Lets the program begin in the machine, or makes one for it.
void Session::begin_program(const std::shared_ptr<const Program>& program) {
  if (vm_ == nullptr) {
    begin_cell(program);
    return;
  }
  take_world(*program);
  vm_->begin(program);
}

void Session::begin_entry() {
  entry_.program = compilation_.program;
  entry_.sources = compilation_.sources;
  begin_program(entry_.program);
  result_ = vm_->result();
  entry_.begin_ns = host_->now_ns();
  entry_.moves = static_cast<std::size_t>(host_->move_count());
  is_under_way_ = true;
}

// The machine gives back its variables after a failure; the cell comes about again.
void Session::end_entry() {
  is_under_way_ = false;
  can_run_ = false;  // an entry runs once
  if (result_.status != Progress::kDone) {
    replay_to(done_, true);
    return;
  }
  entry_.end_ns = host_->now_ns();
  entry_.moves = static_cast<std::size_t>(host_->move_count()) - entry_.moves;
  log_.resize(done_);  // what was undone is forgotten
  log_.push_back(std::exchange(entry_, {}));
  done_ = log_.size();
}

// ---- back and forth --------------------------------------------------------------------------

// Everything is determined by the entries: where one began, all is as those before it leave it when
// they run once more. Nobody hears of that.
void Session::replay_to(std::size_t count, bool from_start) {
  is_silent_ = true;
  can_run_ = false;
  if (from_start || count < done_) {
    vm_.reset();
    if (host_ != nullptr) host_->cell().set_backend(nullptr);
    host_ = nullptr;
    done_ = 0;
  } else if (host_ != nullptr) {
    host_->cell().set_backend(nullptr);
    journal_->set_silent(true);
  }
  std::optional<Problem> parted;
  while (done_ < count && !parted) {
    const Entry& entry = log_[done_];
    begin_program(entry.program);
    vm_->run(Budget{});
    come_to_rest(Budget{});
    const RunResult& result = vm_->result();
    if (result.status == Progress::kDone) {
      ++done_;
    } else {
      parted = Problem{*result.error, entry.sources};
    }
  }
  is_silent_ = false;
  if (parted) {
    // What it reads from outside has changed since.
    log_.resize(done_);
    replay_to(done_, true);
    problems_ = {*std::move(parted)};
  } else if (host_ != nullptr) {
    journal_->set_silent(false);
    listen();
  }
}

std::size_t Session::undo(std::size_t count) {
  require_rest("what is before it can be undone");
  problems_.clear();
  count = std::min(count, done_);
  if (count > 0) replay_to(done_ - count, false);
  take_result();
  return count;
}

void Session::take_result() {
  result_ = vm_ != nullptr ? vm_->result()
                           : RunResult{.status = Progress::kPaused, .error = {}, .steps = 0};
}

std::size_t Session::redo(std::size_t count) {
  require_rest("what was undone can be done again");
  problems_.clear();
  const std::size_t before = done_;
  count = std::min(count, log_.size() - done_);
  if (count > 0) replay_to(done_ + count, false);
  take_result();
  return done_ - before;
}

}  // namespace armlet

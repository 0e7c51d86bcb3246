#pragma once
// The state of a session's run, and the classes that control access to it.

#include <memory>
#include <vector>

#include "armlet/backend/fan_out.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/platform.hpp"
#include "armlet/stdlib/session.hpp"
#include "host/journal.hpp"

namespace armlet {

// The state of the session before an entry, in case that the entry is rolled back; the virtual
// machine restores variables and functions itself.
struct Checkpoint {
  std::unique_ptr<Host> host;  // null: there was no cell
  bool names_objects = false;
  bool decides_picking = false;
  std::vector<Entry> later;  // that were known then
};

struct Session::Run {
  std::vector<Entry> entries;    // known, oldest first
  std::size_t done = 0;          // number of entries that have ended
  bool is_under_way = false;     // the next entry has begun
  bool has_run = false;          // the virtual machine has run a part of it
  bool is_told = false;          // its begin was reported to listeners, its end not yet
  bool names_objects = false;    // by insertObj, in programs that have run in the cell
  bool decides_picking = false;  // by grasp or release
  bool keeps_checkpoints = true;
  RunResult result{.status = Progress::kPaused, .error = {}, .steps = 0};
  std::unique_ptr<Checkpoint> before;  // the entry that is running
  std::unique_ptr<Journal> journal;    // of the entry that has begun last
  std::unique_ptr<Host> host;
  std::unique_ptr<FanOut> fan_out;
  std::unique_ptr<Vm> vm;  // destroyed first

  [[nodiscard]] std::size_t current() const { return is_under_way ? done : done - 1; }
  [[nodiscard]] bool has_later() const { return entries.size() > current() + 1; }
};

// A compiled text with its messages.
struct Session::Compiled {
  Compilation compilation;
  std::vector<Problem> problems;
  std::vector<LoggedImport> imports;
  bool can_run = false;
};

// Discards a stop request when a compilation ends without a program: it has had its effect.
class Session::OneCompilation {
 public:
  explicit OneCompilation(Wish& wish) : wish_(wish) {}
  ~OneCompilation() {
    if (!makes_program_) wish_.forget();
  }
  OneCompilation(const OneCompilation&) = delete;
  OneCompilation& operator=(const OneCompilation&) = delete;

  void makes_program() { makes_program_ = true; }

 private:
  Wish& wish_;
  bool makes_program_ = false;
};

// Allows one slice at a time; discards a stop request when the run ends, however it ends.
class Session::OneSlice {
 public:
  explicit OneSlice(Session& session) : session_(session) {
    if (session_.is_running_.exchange(true, std::memory_order_acquire))
      throw ArgumentError("The session runs already; use another one.");
  }
  ~OneSlice() {
    if (!session_.run_->is_under_way) session_.wish_.forget();
    session_.is_running_.store(false, std::memory_order_release);
  }
  OneSlice(const OneSlice&) = delete;
  OneSlice& operator=(const OneSlice&) = delete;

 private:
  Session& session_;
};

// The virtual machine that `cancel` stops. It is replaced only when no `cancel` is being executed.
// A program that names an object first fills the world, so one virtual machine can replace another.
class Session::InReach {
 public:
  InReach(Session& session, Vm& vm)
      : session_(session), vm_(vm), before_(session.running_.exchange(&vm)) {
    if (session_.wish_.is_new.load() && session_.wish_.is_new.exchange(false)) vm.cancel();
  }
  ~InReach() {
    session_.running_.store(before_);
    while (session_.cancelling_.load() != 0) yield_thread();
    if (before_ == nullptr) return;
    const bool was_heard = vm_.result().status == Progress::kCancelled || vm_.take_cancellation();
    if (was_heard) before_->cancel();
  }
  InReach(const InReach&) = delete;
  InReach& operator=(const InReach&) = delete;

 private:
  Session& session_;
  Vm& vm_;
  Vm* const before_;
};

}  // namespace armlet

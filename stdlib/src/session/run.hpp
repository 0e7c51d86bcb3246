#pragma once
// What a session has of its run, and who may touch it when.

#include <memory>
#include <vector>

#include "armlet/backend/fan_out.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/platform.hpp"
#include "armlet/stdlib/session.hpp"
#include "replay/journal.hpp"

namespace armlet {

// How an entry found the session, in case that it is taken back: the machine gives back variables
// and functions itself.
struct Checkpoint {
  std::unique_ptr<Host> host;  // null: there was no cell
  bool names_objects = false;
  bool decides_picking = false;
  std::vector<Entry> later;  // that were known then
};

struct Session::Run {
  std::vector<Entry> entries;    // known, oldest first
  std::size_t done = 0;          // of these that have ended
  bool is_under_way = false;     // the next one has begun
  bool has_run = false;          // and the machine has run some of it
  bool is_told = false;          // that it has begun, and not yet that it has ended
  bool names_objects = false;    // by insertObj, in what has run in the cell
  bool decides_picking = false;  // by grasp or release
  bool keeps_checkpoints = true;
  RunResult result{.status = Progress::kPaused, .error = {}, .steps = 0};
  std::unique_ptr<Checkpoint> before;  // the entry under way
  std::unique_ptr<Journal> journal;    // of the entry that has begun last
  std::unique_ptr<Host> host;
  std::unique_ptr<FanOut> fan_out;
  std::unique_ptr<Vm> vm;  // goes first

  [[nodiscard]] std::size_t current() const { return is_under_way ? done : done - 1; }
  [[nodiscard]] bool has_later() const { return entries.size() > current() + 1; }
};

// A text that was compiled, and what there is to say about it.
struct Session::Compiled {
  Compilation compilation;
  std::vector<Problem> problems;
  std::vector<LoggedImport> imports;
  bool can_run = false;
};

// Whatever was wished of a compilation that ends with no program has come true with its end.
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

// One slice at a time; what somebody wished of a run ends with it, however it ends.
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

// The machine that `cancel` reaches. It goes only when nobody is about to touch it. A program that
// names an object first fills the world, so one machine can stand before another.
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

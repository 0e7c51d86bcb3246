#pragma once
// Records inputs and replies from outside in the entries of a run, one after the other. In a
// replayed entry, the recorded replies are returned, and the host is neither asked nor informed
// until the replay is past the end of the record.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "armlet/stdlib/session_log.hpp"

namespace armlet {

class Journal {
 public:
  // An entry begins; for a replay, it contains the inputs and replies to come.
  //
  // entry      is filled in here; it must not move until the next one begins.
  // has_later  further entries are known.
  void begin(LoggedEntry& entry, bool has_later);
  // Continues at the end of an entry, because the next one was rolled back.
  void resume(LoggedEntry& entry, bool has_later);
  // The entries that were known after this one belong to another run.
  void forget_later() { has_later_ = false; }

  // While a run is silent it writes no files, prints nothing, reports no events and does not wait
  // for the clock.
  void set_silent(bool silent) { silent_ = silent; }
  [[nodiscard]] bool is_silent() const { return silent_; }
  // Whether runs that are not silent write files.
  void set_keeps_files(bool keeps) { keeps_files_ = keeps; }
  [[nodiscard]] bool keeps_files() const { return keeps_files_; }

  // ---- inputs of the host
  // The next input of the run that is replayed; null: there are no more.
  [[nodiscard]] const Input* next() const;
  void pass() { ++inputs_; }
  // A new input that was just applied, or is to be applied at the start.
  void add(Input input);
  void expect(Input input) { entry_->inputs.push_back(std::move(input)); }

  // ---- questions of the run
  // The reply in the log; otherwise that of `outside`, which is recorded.
  Reply ask(std::string question, const std::function<Reply()>& outside);
  // The reply to saving a file, from the log or from outside; if the file is not written, the run
  // can load it nevertheless.
  Reply save(std::string_view name, std::string_view content,
             const std::function<Reply()>& outside);
  Reply load(const std::string& name, const std::function<Reply()>& outside);
  // Writes output. Only a refusal is recorded.
  std::string print(std::string_view text, const std::function<std::string()>& outside);

  // ---- time
  // The time at which the clock was stopped, if that is before `until_ns`.
  [[nodiscard]] std::optional<std::int64_t> next_stop(std::int64_t now_ns,
                                                      std::int64_t until_ns) const;
  void pass_stop() { ++stops_; }
  void stop_time(std::int64_t now_ns);

  // After a slice: the instant that the run has reached, and where it noticed stop requests.
  void note(const Instant& place, std::span<const Cancellation> cancelled);

  // An input came that the log does not contain: the rest of the log belongs to another run, which
  // left_run() returns once.
  void part();
  [[nodiscard]] bool has_left() const { return left_.has_value(); }
  [[nodiscard]] std::optional<LoggedEntry> left_run() { return std::exchange(left_, std::nullopt); }
  // Whether the log has nothing more for this run.
  [[nodiscard]] bool is_at_its_end() const;

 private:
  void note_cancelled(std::span<const Cancellation> cancelled);
  Reply keep_unwritten(std::string_view name, std::string_view content);

  LoggedEntry* entry_ = nullptr;
  bool has_later_ = false;
  std::size_t inputs_ = 0;  // number of inputs that have taken effect
  std::size_t replies_ = 0;
  std::size_t stops_ = 0;
  std::size_t cancelled_ = 0;
  std::uint64_t pieces_ = 0;  // number of outputs
  Instant place_{};
  bool silent_ = false;
  bool keeps_files_ = true;
  std::optional<LoggedEntry> left_;
  std::map<std::string, std::string, std::less<>> unwritten_;  // by name: saved files not written
  std::size_t unwritten_bytes_ = 0;
};

}  // namespace armlet

#pragma once
// Keeps what comes from outside into the entries of a run, one after the other. One that is
// repeated gets from here what the first one got, and nobody outside is asked or told until it goes
// beyond.

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
  // An entry begins, with what is to come in it if it is repeated.
  //
  // entry      is filled in here; it stays where it is until the next one begins.
  // has_later  others are known behind it.
  void begin(LoggedEntry& entry, bool has_later);
  // Back at the end of an entry: the next one was taken back.
  void resume(LoggedEntry& entry, bool has_later);
  // What was known behind it belongs to another run.
  void forget_later() { has_later_ = false; }

  // While a run is silent it writes no files, nothing is printed, nobody is told and time costs
  // none.
  void set_silent(bool silent) { silent_ = silent; }
  [[nodiscard]] bool is_silent() const { return silent_; }
  // Whether files are written at all, by runs that are heard.
  void set_keeps_files(bool keeps) { keeps_files_ = keeps; }
  [[nodiscard]] bool keeps_files() const { return keeps_files_; }

  // ---- what the host does
  // The next thing that it did in the run that this one repeats; null: nothing more.
  [[nodiscard]] const Input* next() const;
  void pass() { ++inputs_; }
  // Something new, which has just been done, or is to be done at the start.
  void add(Input input);
  void expect(Input input) { entry_->inputs.push_back(std::move(input)); }

  // ---- what the run asks
  // As the log has it; otherwise what `outside` says, which is kept.
  Reply ask(std::string question, const std::function<Reply()>& outside);
  // The same for a file that is saved, which can be loaded in the run where it is not written.
  Reply save(std::string_view name, std::string_view content,
             const std::function<Reply()>& outside);
  Reply load(const std::string& name, const std::function<Reply()>& outside);
  // Writes output. Only what is refused counts.
  std::string print(std::string_view text, const std::function<std::string()>& outside);

  // ---- time
  // Where time does not pass on from, if that lies before `until_ns`.
  [[nodiscard]] std::optional<std::int64_t> next_stop(std::int64_t now_ns,
                                                      std::int64_t until_ns) const;
  void pass_stop() { ++stops_; }
  void stop_time(std::int64_t now_ns);

  // After a slice: how far the run has come, and where it noticed wishes to stop.
  void note(const Instant& place, std::span<const Cancellation> cancelled);

  // Something happened that the log does not have: whatever follows in it belongs to another run,
  // which left_run() gives, once.
  void part();
  [[nodiscard]] bool has_left() const { return left_.has_value(); }
  [[nodiscard]] std::optional<LoggedEntry> left_run() { return std::exchange(left_, std::nullopt); }
  // Whether nothing of the log is to come.
  [[nodiscard]] bool is_at_its_end() const;

 private:
  void note_cancelled(std::span<const Cancellation> cancelled);
  Reply keep_unwritten(std::string_view name, std::string_view content);

  LoggedEntry* entry_ = nullptr;
  bool has_later_ = false;
  std::size_t inputs_ = 0;  // that have taken effect
  std::size_t replies_ = 0;
  std::size_t stops_ = 0;
  std::size_t cancelled_ = 0;
  std::uint64_t pieces_ = 0;  // of output
  Instant place_{};
  bool silent_ = false;
  bool keeps_files_ = true;
  std::optional<LoggedEntry> left_;
  std::map<std::string, std::string, std::less<>> unwritten_;  // by name: saved, and not written
  std::size_t unwritten_bytes_ = 0;
};

}  // namespace armlet

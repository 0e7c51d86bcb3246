// Changes of the text of a program during its run.

#include <algorithm>
#include <optional>
#include <utility>

#include "armlet/backend/run_hash.hpp"
#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "session/run.hpp"

namespace armlet {
namespace {

// The events of a run, and the statement that its program was executing at each.
class Tape : public Backend {
 public:
  struct Told {
    std::uint64_t number;
    std::uint64_t hash;
    std::int64_t t_ns;
    Span at;
  };

  explicit Tape(Session& session) : session_(session) {}
  void on(const Event& event) override {
    if (ignores().has(kind_of(event))) return;
    RunHash one;
    one.on(event);
    told_.push_back({number_of(event), one.value(), time_of(event), at()});
  }
  [[nodiscard]] EventKinds ignores() const override { return RunHash().ignores(); }
  [[nodiscard]] const std::vector<Told>& told() const { return told_; }
  [[nodiscard]] Span at() const {
    return session_.vm() == nullptr ? Span{} : running_at(*session_.vm());
  }

 private:
  Session& session_;
  std::vector<Told> told_;
};

// The first difference of the tapes. A paused run may lack events of its last instant.
//
// undone  the first event of `before` that is missing in `now`, if there is one.
TextChange compare(const Tape& before, const Tape& now, bool had_ended, const SourceSet& texts,
                   std::optional<std::uint64_t>& undone) {
  const auto is_same = [](const Tape::Told& a, const Tape::Told& b) { return a.hash == b.hash; };
  const auto [old, fresh] = std::mismatch(before.told().begin(), before.told().end(),
                                          now.told().begin(), now.told().end(), is_same);
  const bool is_longer = fresh != now.told().end();
  const bool is_shorter = old != before.told().end();
  if (is_shorter) undone = old->number;
  if (!is_shorter && (!is_longer || !had_ended)) return {.outcome = TextChange::Outcome::kSame};
  TextChange change{.outcome = TextChange::Outcome::kParts};
  if (old != before.told().begin()) change.same_ns = std::prev(old)->t_ns;
  if (is_longer && is_shorter) {
    change.parts_ns = std::min(old->t_ns, fresh->t_ns);
  } else {
    change.parts_ns = is_longer ? fresh->t_ns : old->t_ns;
  }
  const Span at = is_longer ? fresh->at : now.at();
  change.line = at.empty() ? 0 : texts.position(at).line;
  return change;
}

}  // namespace

TextChange Session::change(std::string text, std::int64_t t_ns) {
  require_idle("take another text");
  return change(entry_at(t_ns), std::move(text), t_ns);
}

// The entries up to one that gets another text; none if the new text cannot run.
std::vector<Entry> Session::with_text(const std::vector<Entry>& known, std::size_t entry,
                                      std::string text, std::int64_t t_ns) {
  const LoggedEntry& old = known[entry].logged;
  if (old.kind == EntryKind::kCall)
    throw ArgumentError("A call has no text; change the entry that declares its function.");
  std::shared_ptr<const Program> after;
  for (std::size_t i = 0; i < entry; ++i)
    if (known[i].program != nullptr) after = known[i].program;

  LoggedEntry fresh{.kind = old.kind, .name = old.name, .text = std::move(text)};
  Compiled made = compile_text(fresh, after, false);
  problems_ = std::move(made.problems);
  if (!made.can_run) return {};
  fresh.imports = std::move(made.imports);
  fresh.inputs = old.inputs;
  fresh.replies = old.replies;
  fresh.end = {t_ns + 1, 0};  // includes the whole instant
  std::vector<Entry> entries(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(entry));
  entries.push_back({.logged = std::move(fresh), .program = made.compilation.program});
  return entries;
}

TextChange Session::change(std::size_t entry, std::string text, std::int64_t t_ns) {
  require_idle("take another text");
  static_cast<void>(sources());
  require_time(entry, t_ns);
  const OneSlice one_slice(*this);
  std::vector<Entry> known = run_->entries;
  if (known.empty()) known.push_back(*submitted_);
  const std::vector<Entry> entries = with_text(known, entry, std::move(text), t_ns);
  if (entries.empty()) return {};

  std::unique_ptr<Run> former = std::exchange(run_, std::make_unique<Run>());
  const Compilation compiled = compilation_;
  const auto rehearse = [&](const std::vector<Entry>& rehearsed, Tape& tape) {
    confidant_ = &tape;
    const bool is_there = take_again(rehearsed, [&] { return run_again_to(entry, t_ns); });
    confidant_ = nullptr;
    return is_there;
  };
  Tape before(*this);
  Tape now(*this);
  const auto give_up_change = [&] {
    confidant_ = nullptr;
    compilation_ = compiled;
    run_ = std::move(former);
  };
  bool is_there = false;
  bool had_ended = false;
  try {
    is_there = rehearse(known, before);
    had_ended = is_there && !run_->is_under_way;
    is_there = is_there && rehearse(entries, now);
  } catch (...) {
    give_up_change();
    throw;
  }
  if (!is_there) {
    give_up_change();
    return {};
  }
  std::optional<std::uint64_t> undone;
  const TextChange change = compare(before, now, had_ended, *compilation_.sources, undone);
  if (undone) tell_undone(*former, run_->host.get(), undone);
  if (run_->fan_out != nullptr) run_->fan_out->set_backends(options_.backends);
  submitted_.reset();
  keep_run(log_of(known));
  run_->journal->part();
  static_cast<void>(run_->journal->left_run());
  return change;
}

}  // namespace armlet

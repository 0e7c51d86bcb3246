// A run with another text of its program.

#include <algorithm>
#include <utility>

#include "armlet/backend/fan_out.hpp"
#include "armlet/backend/run_hash.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "armlet/stdlib/session.hpp"
#include "replay/former.hpp"

namespace armlet {
namespace {

// The events of a run, and where its program was then.
class Tape : public Backend {
 public:
  struct Told {
    std::uint64_t hash;
    std::int64_t t_ns;
    Span at;
  };

  explicit Tape(Session& session) : session_(session) {}
  void on(const Event& event) override {
    if (ignores().has(kind_of(event))) return;
    RunHash one;
    one.on(event);
    told_.push_back({one.value(), time_of(event), at()});
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

// Where the tapes differ. A run that has paused might have told more at its last instant.
TextChange compare(const Tape& before, const Tape& now, bool had_ended, const SourceSet& texts) {
  const auto is_same = [](const Tape::Told& a, const Tape::Told& b) { return a.hash == b.hash; };
  const auto [old, fresh] = std::mismatch(before.told().begin(), before.told().end(),
                                          now.told().begin(), now.told().end(), is_same);
  const bool is_longer = fresh != now.told().end();
  const bool is_shorter = old != before.told().end();
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
  const LoggedEntry known = known_run();
  require_time(t_ns, known.end);
  SessionOptions quiet = options_;
  quiet.backends.clear();
  Session changed(engine_, quiet);
  if (!changed.compile(std::move(text), known.name)) {
    problems_ = changed.problems_;
    return {};
  }
  LoggedEntry entry = changed.known_run();
  entry.inputs = known.inputs;
  entry.replies = known.replies;
  entry.end = {t_ns + 1, 0};  // the whole of the instant

  Former former = put_aside();
  const Compilation compiled = compilation_;
  const auto rehearse = [&](LoggedEntry run, Tape& tape) {
    confidant_ = &tape;
    const Instant end = run.end;
    const bool is_there = take_again(std::move(run), [&] { run_again_to(t_ns, end); });
    confidant_ = nullptr;
    return is_there;
  };
  Tape before(*this);
  Tape now(*this);
  const auto give_up_change = [&] {
    confidant_ = nullptr;
    compilation_ = compiled;
    bring_back(std::move(former));
  };
  bool is_there = false;
  bool had_ended = false;
  try {
    is_there = rehearse(known, before);
    had_ended = is_there && result_.status != Progress::kPaused;
    compilation_ = changed.compilation_;
    is_there = is_there && rehearse(std::move(entry), now);
  } catch (...) {
    give_up_change();
    throw;
  }
  if (!is_there) {
    give_up_change();
    return {};
  }
  const TextChange change = compare(before, now, had_ended, *compilation_.sources);
  fan_out_->set_backends(options_.backends);
  problems_ = changed.problems_;
  imports_ = changed.imports_;
  runs_.push_back(log_of(known));
  journal_->part();
  static_cast<void>(journal_->left_run());
  return change;
}

}  // namespace armlet

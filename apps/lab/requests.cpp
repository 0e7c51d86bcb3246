// How a laboratory handles each message of a page.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/backend/event.hpp"
#include "armlet/backend/run_marks.hpp"
#include "armlet/cell/clock.hpp"
#include "armlet/interpreter/format.hpp"
#include "armlet/interpreter/reference.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/kinematics/dragged_tool.hpp"
#include "armlet/stdlib/install.hpp"
#include "laboratory_state.hpp"

namespace armlet::lab {
namespace {

constexpr double kMostSeconds = 1e9;
constexpr std::size_t kMostLooks = 200;

std::map<std::string, std::vector<std::string>> words_of_language() {
  std::map<std::string, std::vector<std::string>> words;
  for (const LanguageWord& word : reserved_and_soft_words())
    words[word.soft ? "soft" : "keywords"].emplace_back(word.text);
  words["functions"] = help_names(library_engine());
  for (const Unit& unit : all_units()) words["units"].emplace_back(unit.name);
  for (const std::string_view name : dimension_names()) words["types"].emplace_back(name);
  return words;
}

// A file name that is valid in every folder and in programs: of the last part of the given name at
// most 60 letters, digits, points, underscores and hyphens; the first one is no point.
std::string file_name(std::string_view given) {
  given = given.substr(given.find_last_of("/\\") + 1);
  std::string name;
  bool has_letter = false;
  for (const char c : given) {
    const bool is_letter =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    has_letter = has_letter || is_letter;
    if (is_letter || c == '_' || (c == '.' && !name.empty())) name += c;
    if (!(is_letter || c == '_' || c == '.') && !name.ends_with('-') && !name.empty()) name += '-';
  }
  const std::size_t point = name.rfind('.');
  const std::string ending = point == std::string::npos ? std::string() : name.substr(point);
  if (!has_letter || ending.size() > 8) return {};
  name = name.substr(0, std::min<std::size_t>(60, point));
  while (name.ends_with('-') || name.ends_with('.')) name.pop_back();
  return name.empty() ? std::string() : name + ending;
}

std::vector<double> numbers_of(const Eigen::VectorXd& q) { return {q.begin(), q.end()}; }

}  // namespace

void Laboratory::State::refuse(Page& page, Seq seq, std::string_view reason,
                               std::string_view message) {
  pages.answer(page, write_error(seq, reason, message));
}

void Laboratory::State::refuse(Page& page, Seq seq, const InputFault& fault) {
  const UnreachedGoal* goal = fault.unreached ? &*fault.unreached : nullptr;
  pages.answer(page, write_error(seq, "refused", fault.why, goal));
}

bool Laboratory::State::has_control(Page& page, Seq seq) {
  if (pages.is_holder(page.number)) return true;
  refuse(page, seq, "control", "Another page is in control; take it first.");
  return false;
}

void Laboratory::State::handle(Page& page, const Request& request) {
  if (!page.is_greeted && !std::holds_alternative<Hello>(request.what))
    return refuse(page, request.seq, "message", "The first message of a page is \"hello\".");
  std::visit([&](const auto& each) { handle(page, request.seq, each); }, request.what);
}

void Laboratory::State::handle(Page& page, Seq seq, const Hello& hello) {
  const bool is_first = !page.is_greeted;
  page.is_greeted = true;
  page.known = {};
  page.known.text = versions.text;
  page.runs.clear();
  pages.answer(page, write_welcome({.page = page.number,
                                    .key = page.key,
                                    .version = options.version,
                                    .file = options.file,
                                    .text = text.now,
                                    .text_version = text.version,
                                    .is_demo = options.is_demo,
                                    .words = words_of_language()},
                                   seq));
  if (is_first) pages.enter(page.number, hello.key);
}

// ---- the text -------------------------------------------------------------------------------

void Laboratory::State::handle(Page& page, Seq seq, const SetText& given) {
  if (!has_control(page, seq)) return;
  text.from = page.number;
  take_text(given.text, given.version, given.runs, given.change);
}

void Laboratory::State::handle(Page& page, Seq /*seq*/, const SetName& given) {
  pages.set_name(page.number, given.name);
}

void Laboratory::State::handle(Page& page, Seq seq, const AskText& ask) {
  const Analysis& known = analysis();
  const SourceSet& sources = known.sources();
  const std::uint32_t at = byte_of(sources[sources.first()], ask.at);
  switch (ask.what) {
    case AskText::What::kComplete:
      return pages.answer(page, write_completion(seq, known, at));
    case AskText::What::kHover:
      return pages.answer(page, write_hover(seq, known, at));
    case AskText::What::kSignature:
      return pages.answer(page, write_signature(seq, known, at));
    case AskText::What::kDefinition:
      return pages.answer(page, write_definition(seq, known, at));
  }
}

void Laboratory::State::handle(Page& page, Seq seq, const FormatText&) {
  SourceSet sources;
  const Source& source = sources.add(options.file, text.now);
  const Formatted formatted = format_program(source);
  std::vector<TextMessage> problems;
  for (const Diagnostic& each : formatted.problems) problems.push_back(resolved(each, sources));
  pages.answer(page, write_formatted(seq, formatted.text, problems));
}

// ---- instants -------------------------------------------------------------------------------

RunRecord* Laboratory::State::run_to_see(Page& page, Seq seq, std::optional<int> number, double t) {
  RunRecord* run = number ? find_run(*number) : shown_run();
  if (run == nullptr) {
    refuse(page, seq, "refused", "There is no such run.");
  } else if (log_of(*run) == nullptr || !(t >= 0.0) || t > run->t_end + 1e-9) {
    refuse(page, seq, "refused",
           fmt::format("The run has come to t = {:.3f} s; there is no t = {:.3f} s to go to.",
                       run->t_end, std::min(t, kMostSeconds)));
    return nullptr;
  }
  return run;
}

void Laboratory::State::handle(Page& page, Seq seq, const AskPicture& ask) {
  RunRecord* run = run_to_see(page, seq, ask.run, ask.t);
  if (run == nullptr) return;
  ask_to_look({.page = page.number,
               .seq = seq,
               .run = run->number,
               .place = {.t_ns = to_ns(std::min(ask.t, run->t_end)), .statements = {}},
               .step = {},
               .picture = ask.element});
}

void Laboratory::State::handle(Page& page, Seq seq, const GoTo& go) {
  RunRecord* run = run_to_see(page, seq, go.run, go.t);
  if (run == nullptr) return;
  ask_to_look({.page = page.number,
               .seq = seq,
               .run = run->number,
               .place = {.t_ns = to_ns(std::min(go.t, run->t_end)), .statements = {}},
               .step = {},
               .moves_cursor = pages.is_holder(page.number) && !go.looks,
               .looks_only = go.looks});
}

void Laboratory::State::handle(Page& page, Seq seq, const Step& step) {
  if (!has_control(page, seq)) return;
  RunRecord* run = shown_run();
  if (run == nullptr || log_of(*run) == nullptr)
    return refuse(page, seq, "refused", "There is no run to step through.");
  Look wish{.page = page.number,
            .seq = seq,
            .run = run->number,
            .place = {.t_ns = 0, .statements = 0},
            .step = step.how,
            .moves_cursor = true};
  if (cursor && cursor->run == run->number) wish.place = cursor->place;
  ask_to_look(wish);
}

void Laboratory::State::ask_to_look(Look wish) {
  if (!wish.step) {
    // Only the newest of several instants that a page requests is shown.
    Page* page = pages.find(wish.page);
    std::erase_if(looks.waiting, [&](const Look& each) {
      if (each.page != wish.page || each.step || each.picture != wish.picture) return false;
      if (page != nullptr && !each.picture.empty())
        refuse(*page, each.seq, "refused", "A newer question has taken its place.");
      return true;
    });
  }
  if (looks.waiting.size() >= kMostLooks) {
    Page* page = pages.find(wish.page);
    if (page != nullptr) refuse(*page, wish.seq, "limit", "Too many steps are waiting.");
    return;
  }
  looks.waiting.push_back(std::move(wish));
}

void Laboratory::State::handle(Page& page, Seq seq, const SetBreakpoints& given) {
  if (!has_control(page, seq)) return;
  const std::vector<int>& known = breakpoints.known;
  std::vector<int>& lines = breakpoints.lines;
  lines.clear();
  for (const int line : given.lines) {
    const auto next = std::ranges::lower_bound(known, line);
    if (next != known.end()) lines.push_back(*next);
  }
  std::ranges::sort(lines);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  ++versions.breakpoints;
  page.known.breakpoints = versions.breakpoints;
  pages.answer(page, write_breakpoints(seq, lines, known));
}

// ---- inverse kinematics ---------------------------------------------------------------------

void Laboratory::State::handle(Page& page, Seq seq, const AskInverse& ask) {
  RunRecord* run = shown_run();
  const std::optional<int> robot = run == nullptr ? std::nullopt : run->find_robot(ask.robot);
  const std::shared_ptr<const Robot> model = robot ? run->model_at(*robot, run->t_end) : nullptr;
  if (model == nullptr)
    return refuse(page, seq, "refused", fmt::format("There is no robot \"{}\".", ask.robot));
  const std::vector<double> given =
      ask.seed.empty() ? run->joints_at(*robot, run->t_end) : ask.seed;
  const Eigen::Map<const Eigen::VectorXd> seed(given.data(),
                                               static_cast<Eigen::Index>(given.size()));
  if (seed.size() != model->n()) {
    return refuse(page, seq, "refused",
                  fmt::format("A seed for \"{}\" has {} numbers, not {}.", ask.robot, model->n(),
                              seed.size()));
  }
  // The goals of a page are on the path of a pointer: the arm follows it and does not jump.
  const Eigen::Isometry3d T_goal = pose_to_keep(*model, ask.T_world_tool, seed);
  const DraggedTool dragged = drag_tool(*model, T_goal, seed);
  const bool is_there = model->n() < 6 ? dragged.has_position() : dragged.has_pose();
  InverseAnswer answer{.is_ok = is_there, .q = numbers_of(dragged.q), .reason = {}, .nearest = {}};
  if (!is_there) {
    answer.reason = explain(*model, T_goal, dragged);
    answer.nearest = InverseAnswer::Nearest{.q = numbers_of(dragged.q),
                                            .T_world_tool = dragged.T_world_tool,
                                            .distance = dragged.distance,
                                            .angle = dragged.angle};
  }
  pages.answer(page, write_inverse(seq, answer));
}

// ---- runs -----------------------------------------------------------------------------------

void Laboratory::State::handle(Page& page, Seq seq, const ShowRun& given) {
  if (!has_control(page, seq)) return;
  if (find_run(given.run) == nullptr) return refuse(page, seq, "refused", "There is no such run.");
  show(given.run);
}

void Laboratory::State::handle(Page& page, Seq seq, const CompareRuns& given) {
  const RunRecord* run = find_run(given.run);
  const RunRecord* with = find_run(given.with);
  if (run == nullptr || with == nullptr)
    return refuse(page, seq, "refused", "There is no such run.");
  if (run->state == RunState::kRunning || with->state == RunState::kRunning)
    return refuse(page, seq, "refused", "A run that is under way cannot be compared yet.");
  Comparison out{.run = run->number, .with = with->number};
  const std::optional<RunParting> parting = where_runs_part(run->marks, with->marks);
  out.is_same = !parting;
  out.same_until = parting ? to_seconds(parting->same_ns) : run->t_end;
  if (parting) {
    out.parts_at = to_seconds(parting->differ_ns);
    out.line = run->line_at(out.parts_at);
    out.line_with = with->line_at(out.parts_at);
  }
  pages.answer(page, write_comparison(seq, out));
}

void Laboratory::State::handle(Page& page, Seq seq, const FetchRun& given) {
  if (find_run(given.run) == nullptr) return refuse(page, seq, "refused", "There is no such run.");
  page.runs.erase(given.run);
  page.wanted.insert(given.run);
}

void Laboratory::State::handle(Page& page, Seq seq, const StopRun&) {
  if (has_control(page, seq)) end_live_run("It was stopped from a page.");
}

void Laboratory::State::handle(Page& page, Seq seq, const AskExport&) {
  for (const auto& run : runs) {
    if (const SessionLog* log = log_of(*run)) imported->add_loaded(*log);
  }
  pages.answer(page,
               write_exported(
                   seq, {.version = options.version,
                         .robot = options.session.robot == nullptr ? std::string()
                                                                   : options.session.robot->name(),
                         .world = options.session.world ? &*options.session.world : nullptr,
                         .file = options.file,
                         .text = text.now,
                         .is_demo = options.is_demo,
                         .files = imported->all(),
                         .runs = runs,
                         .shown = shown}));
}

// ---- files ----------------------------------------------------------------------------------

void Laboratory::State::handle(Page& page, Seq seq, const AskFile& ask) {
  const FileBytes bytes = files.find(ask.name);
  if (bytes == nullptr || !seq || bytes->size() > 0xFFFF'FFFF)
    return refuse(page, seq, "refused", "There is no such file.");
  pages.answer(page, write_file(static_cast<std::uint32_t>(*seq), *bytes));
}

void Laboratory::State::handle(Page& page, Seq seq, const SendFile& sent) {
  if (!has_control(page, seq)) return;
  if (!options.keep_file)
    return refuse(page, seq, "refused", "This laboratory has no folder to keep a file in.");
  if (sent.first) page.sent = {.name = sent.name, .bytes = {}};
  if (page.sent.name != sent.name)
    return refuse(page, seq, "message", "The pieces of a file come one after the other.");
  page.sent.bytes += sent.bytes;
  if (page.sent.bytes.size() > kMostFileBytes) {
    page.sent = {};
    return refuse(page, seq, "limit",
                  fmt::format("A file that is kept has at most {} MB.", kMostFileBytes >> 20U));
  }
  if (!sent.last) return pages.answer(page, write_kept(seq, {}));
  const Page::Sent file = std::exchange(page.sent, {});
  const std::string name = file_name(file.name);
  if (name.empty())
    return refuse(page, seq, "refused", "The name of the file has no letters or digits.");
  if (pages.kept_bytes() + file.bytes.size() > options.most_kept_bytes)
    return refuse(
        page, seq, "limit",
        fmt::format("A laboratory keeps {} MB of files at most.", options.most_kept_bytes >> 20U));
  const Result<KeptFile> kept = options.keep_file(name, file.bytes);
  if (!kept.ok()) return refuse(page, seq, "refused", kept.error().message);
  pages.count_kept(file.bytes.size());
  pages.answer(page, write_kept(seq, *kept));
}

void Laboratory::State::handle(Page& page, Seq, const TakeControl&) { pages.take(page.number); }

void Laboratory::State::handle(Page& page, Seq seq, const GiveControl& given) {
  if (!has_control(page, seq)) return;
  if (!pages.give(given.to)) refuse(page, seq, "refused", "There is no such page.");
}

// ---- inputs ---------------------------------------------------------------------------------

void Laboratory::State::handle(Page& page, Seq seq, const GiveInput& given) {
  if (!has_control(page, seq)) return;
  RunRecord* run = shown_run();
  if (run == nullptr || log_of(*run) == nullptr)
    return refuse(page, seq, "refused", "There is no run yet.");
  LiveRun* under_way = live_run(*run);
  const bool is_at_end = !given.t || *given.t >= run->t_end - 1e-9;
  if (is_at_end && under_way != nullptr && under_way->has_forked()) {
    if (const auto why = under_way->give(given.what)) return refuse(page, seq, *why);
    forget_looks_of(*run);
    return pages.answer(page, write_taken(seq, run->number));
  }
  if (run->state == RunState::kRunning || (given.t && !(*given.t >= 0.0)))
    return refuse(page, seq, "refused", "The run has not come there yet.");
  fork_asked = Asked{.page = page.number, .seq = seq, .shown_before = shown};
  begin_fork(*run, to_ns(is_at_end ? run->t_end : *given.t), given);
}

}  // namespace armlet::lab

#include "check/names/suggest.hpp"

#include <algorithm>
#include <array>

#include "armlet/core/similar.hpp"
#include "syntax/tokens/foreign_words.hpp"

namespace armlet::lang {
namespace {

// Names of functions and types; words are in syntax/tokens/foreign_words.hpp.
constexpr auto kNames = std::to_array<ForeignName>({
    // robot languages
    {"MoveAbsJ", "moveJ", "moveJ with a posJ moves the joints"},
    {"MoveJ", "moveJ", ""},
    {"MoveL", "moveL", ""},
    {"MoveC", "moveCirc", "here C stands for Cartesian; arcs are moveCirc(via, goal)"},
    {"PTP", "moveJ", ""},
    {"LIN", "moveL", ""},
    {"CIRC", "moveCirc", ""},
    {"SPTP", "moveJ", ""},
    {"SLIN", "moveL", ""},
    {"movej", "moveJ", ""},
    {"movel", "moveL", ""},
    {"movec", "moveCirc", ""},
    {"movep", "moveL", ""},
    {"WaitTime", "wait", ""},
    {"WaitUntil", "wait until", ""},
    {"sleep", "wait", "only the virtual clock passes"},
    {"delay", "wait", "only the virtual clock passes"},
    {"open_gripper", "release", ""},
    {"close_gripper", "grasp", ""},
    // other languages
    {"println", "print", ""},
    {"printf", "print", "print takes f\"...\" for formatted text"},
    {"console.log", "print", ""},
    {"console.error", "print", ""},
    {"System.err.println", "print", ""},
    {"io.write", "print", ""},
    {"time.sleep", "wait", ""},
    {"time.time", "now", ""},
    {"std.cout", "print", ""},
    {"cout", "print", ""},
    {"disp", "print", ""},
    {"Serial.println", "print", ""},
    {"echo", "print", ""},
    {"pi", "PI", ""},
    {"len", "length", "the length of a list is xs.length"},
    {"append", "push", ""},
    {"add", "push", ""},
    {"push_back", "push", ""},
    {"size", "length", ""},
    {"toFixed", "round", "a format shows digits: f\"{x:.2f}\""},
    {"str", "string", ""},
    {"to_string", "string", ""},
    {"String.valueOf", "string", ""},
    {"num2str", "string", ""},
    {"char", "string", "a single character is a text of length 1"},
    {"charAt", "", "a single character of a text is s[i]"},
    {"get", "", "a value of a list is xs[i]"},
    // figures
    {"bar", "bars", ""},
    {"qplot", "plot", ""},
    {"plot3", "scatter3", ""},
    {"savefig", "savePlot", ""},
    {"saveas", "savePlot", ""},
    {"title", "", "the title of a figure is given where it begins: figure(\"speed\")"},
    {"legend", "", "a line gets its name where it is drawn: plot(t, y, label: \"joint 1\")"},
    {"xlabel", "", "axes get their units from the types of what is drawn"},
    {"ylabel", "", "axes get their units from the types of what is drawn"},
    {"subplot", "", "each figure(\"...\") is a picture; plot(tr) and plot(run) draw panels"},
    {"semilogx", "", "figure(\"...\", log: \"x\") before plot(x, y) makes the axis logarithmic"},
    {"semilogy", "", "figure(\"...\", log: \"y\") before plot(x, y) makes the axis logarithmic"},
    {"loglog", "", "figure(\"...\", log: \"xy\") before plot(x, y) makes the axes logarithmic"},
});

constexpr auto kForeign = [] {
  constexpr auto kWords = std::ranges::count(kForeignWords, true, &ForeignWord::alone);
  std::array<ForeignName, kNames.size() + static_cast<std::size_t>(kWords)> all{};
  auto* end = std::ranges::copy(kNames, all.begin()).out;
  for (const ForeignWord& word : kForeignWords) {
    if (word.alone) *end++ = {word.found, word.meant, ""};
  }
  return all;
}();

struct ForeignSetting {
  std::string_view foreign;
  std::string_view here;
};

constexpr ForeignSetting kForeignSettings[] = {
    {"velocity", "speed"},  {"vel", "speed"},     {"v", "speed"},       {"acceleration", "accel"},
    {"acc", "accel"},       {"a", "accel"},       {"duration", "time"}, {"t", "time"},
    {"zone", "blend"},      {"radius", "blend"},  {"r", "blend"},       {"planner", "traj"},
    {"trajectory", "traj"}, {"tolerance", "tol"}, {"tcp", "tool"},      {"wobj", "frame"},
    {"base", "frame"},
};

}  // namespace

std::optional<Candidate> suggest(std::string_view name, std::span<const Candidate> candidates,
                                 const Type* wanted) {
  std::optional<Candidate> best;
  std::size_t best_score = 0;
  for (const Candidate& candidate : candidates) {
    const std::string_view one[] = {candidate.name};
    if (candidate.name == name || !most_similar(name, one)) continue;
    const bool other_type = wanted != nullptr && candidate.type != wanted;
    // One edit and a half for another type, so that a fitting type also wins a tie.
    const std::size_t score = 2 * edit_distance(name, candidate.name) + (other_type ? 3 : 0);
    if (best && score >= best_score) continue;
    best = candidate;
    best_score = score;
  }
  return best;
}

std::optional<std::string_view> suggest(std::string_view name,
                                        std::span<const std::string_view> candidates) {
  return most_similar(name, candidates);
}

const ForeignName* foreign_name(std::string_view word) {
  const auto found = std::ranges::find(kForeign, word, &ForeignName::foreign);
  return found == kForeign.end() ? nullptr : &*found;
}

std::span<const ForeignName> foreign_names() { return kForeign; }

std::string_view foreign_setting(std::string_view word) {
  const auto found = std::ranges::find(kForeignSettings, word, &ForeignSetting::foreign);
  return found == std::ranges::end(kForeignSettings) ? std::string_view() : found->here;
}

}  // namespace armlet::lang

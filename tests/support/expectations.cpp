#include "expectations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>
#include <stdexcept>

namespace armlet::test {
namespace {

using Message = Expectations::Message;

const std::regex kComment(R"(^(.*?)\s*//\s?(expect\b.*|run: .*)$)");
const std::regex kOutput(R"(^expect:(?: (.*))?$)");
const std::regex kAbout(R"(^expect about: (.*) within (\S+)$)");
const std::regex kMessage(R"(^expect (?:error|advice) ([ERW]\d{4})(?: at (\d+))?(?:: (.*))?$)");
const std::regex kExit(R"(^expect exit: (\d+)$)");
const std::regex kShown(R"(^expect shown(?: as (\S+))?:$)");
const std::regex kShownLine(R"(^// ?\| ?(.*)$)");
const std::regex kHeadline(R"(^(?:error|advice) ([ERW]\d{4}): (.*)$)");
const std::regex kPlace(R"(^ *--> .*:(\d+):(\d+)$)");
const std::regex kBelow(R"(^ *(?:-->|\d* \||=|\.\.\.| {10}\S).*$)");

struct Comment {
  std::string code;  // what stands before it, without trailing blanks
  std::string body;  // from "expect" on
};

std::optional<Comment> comment_of(const std::string& line) {
  std::smatch match;
  if (!std::regex_match(line, match, kComment)) return std::nullopt;
  return Comment{match[1], match[2]};
}

// Reads one expectation; `line` is where it stands, `about` the line of the program it speaks of.
bool read_expectation(const std::string& body, int line, int about, Expectations& out) {
  std::smatch m;
  if (std::regex_match(body, m, kAbout)) {
    out.output.push_back({m[1], std::strtod(m[2].str().c_str(), nullptr), line});
  } else if (std::regex_match(body, m, kMessage)) {
    out.messages.push_back({m[1], m[3], about, m[2].matched ? std::stoi(m[2]) : 0});
  } else if (std::regex_match(body, m, kExit)) {
    out.exit = std::stoi(m[1]);
  } else if (std::regex_match(body, m, kOutput)) {
    out.output.push_back({m[1], std::nullopt, line});
  } else if (body.starts_with("run: ")) {
    out.command = body.substr(5);
  } else if (std::regex_match(body, m, kShown)) {
    out.shown_as = m[1];
  } else {
    return false;
  }
  return true;
}

// The messages that a shown text consists of.
std::vector<Message> messages_in(const std::vector<std::string>& shown) {
  std::vector<Message> messages;
  for (const std::string& line : shown) {
    std::smatch m;
    if (std::regex_match(line, m, kHeadline)) {
      messages.push_back({m[1], m[2]});
    } else if (!messages.empty() && std::regex_match(line, m, kPlace)) {
      messages.back().line = std::stoi(m[1]);
      messages.back().column = std::stoi(m[2]);
    }
  }
  return messages;
}

std::string describe(const Message& message) {
  return fmt::format("{} on line {}{}: {}", message.code, message.line,
                     message.column ? fmt::format(", column {}", message.column) : "",
                     message.text);
}

bool fits(const Message& expected, const Message& actual) {
  return expected.code == actual.code && expected.line == actual.line &&
         (expected.column == 0 || expected.column == actual.column) &&
         actual.text.find(expected.text) != std::string::npos;
}

void compare_output(const Expectations& expected, const Outcome& actual,
                    std::vector<std::string>& found) {
  const std::size_t common = std::min(expected.output.size(), actual.output.size());
  for (std::size_t i = 0; i < common; ++i) {
    const auto& want = expected.output[i];
    const bool same = want.within ? about_equal(want.text, actual.output[i], *want.within)
                                  : want.text == actual.output[i];
    if (!same)
      found.push_back(fmt::format("line {}: expected '{}', printed '{}'", want.line, want.text,
                                  actual.output[i]));
  }
  for (std::size_t i = common; i < expected.output.size(); ++i)
    found.push_back(fmt::format("line {}: expected '{}', printed nothing more",
                                expected.output[i].line, expected.output[i].text));
  for (std::size_t i = common; i < actual.output.size(); ++i)
    found.push_back(fmt::format("printed '{}', which is not expected", actual.output[i]));
}

void compare_messages(const Expectations& expected, const Outcome& actual,
                      std::vector<std::string>& found) {
  std::vector<Message> left = actual.messages;
  for (const Message& want : expected.messages) {
    const auto it =
        std::find_if(left.begin(), left.end(), [&](const Message& m) { return fits(want, m); });
    if (it == left.end())
      found.push_back("missing message " + describe(want));
    else
      left.erase(it);
  }
  for (const Message& extra : left) found.push_back("message not expected: " + describe(extra));
}

std::string join(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// The lines of the program with their output and message comments taken off; lines that held
// nothing else are dropped. `kept[i]` is the new number of old line i.
struct Stripped {
  std::vector<std::string> lines;
  std::map<int, int> kept;
};

Stripped strip(const std::vector<std::string>& lines) {
  Stripped result;
  int number = 0;
  bool in_shown = false;
  for (const std::string& line : lines) {
    ++number;
    if (in_shown && std::regex_match(line, kShownLine)) continue;
    const auto comment = comment_of(line);
    in_shown = comment && std::regex_match(comment->body, kShown);
    const bool stays =
        !comment || comment->body.starts_with("run: ") || std::regex_match(comment->body, kExit);
    if (stays || !comment->code.empty()) result.lines.push_back(stays ? line : comment->code);
    result.kept[number] = static_cast<int>(result.lines.size());
  }
  return result;
}

}  // namespace

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

Expectations parse_expectations(std::string_view source) {
  Expectations result;
  int line = 0, program_line = 0;
  bool in_shown = false;
  for (const std::string& text : split_lines(source)) {
    ++line;
    std::smatch shown;
    if (in_shown && std::regex_match(text, shown, kShownLine)) {
      result.shown.push_back(shown[1]);
      continue;
    }
    const auto comment = comment_of(text);
    in_shown = comment && std::regex_match(comment->body, kShown);
    // A comment on a line of its own speaks of the last line that holds something else.
    if (!comment || !comment->code.empty()) program_line = line;
    if (comment && !read_expectation(comment->body, line, program_line, result))
      throw std::invalid_argument(
          fmt::format("line {}: '{}' is none of the forms of an expectation", line, comment->body));
  }
  result.shown_only = result.messages.empty() && !result.shown.empty();
  if (result.shown_only) result.messages = messages_in(result.shown);
  return result;
}

std::vector<std::string> only_messages(const std::vector<std::string>& lines) {
  std::vector<std::string> result;
  bool inside = false;
  for (const std::string& line : lines) {
    inside = std::regex_match(line, kHeadline) || (inside && std::regex_match(line, kBelow));
    if (inside) result.push_back(line);
  }
  return result;
}

int expected_exit(const Expectations& expected) {
  if (expected.exit) return *expected.exit;
  int status = 0;
  for (const Message& message : expected.messages) {
    if (message.code[0] == 'E') return 65;
    if (message.code[0] == 'R') status = 70;
  }
  return status;
}

bool about_equal(std::string_view expected, std::string_view actual, double within) {
  const std::regex number(R"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)");
  const std::string a(expected), b(actual);
  if (std::regex_replace(a, number, "#") != std::regex_replace(b, number, "#")) return false;
  auto x = std::sregex_iterator(a.begin(), a.end(), number);
  auto y = std::sregex_iterator(b.begin(), b.end(), number);
  for (; x != std::sregex_iterator(); ++x, ++y) {
    const double difference =
        std::strtod(x->str().c_str(), nullptr) - std::strtod(y->str().c_str(), nullptr);
    if (!(std::abs(difference) <= within)) return false;
  }
  return true;
}

std::vector<std::string> differences(const Expectations& expected, const Outcome& actual) {
  std::vector<std::string> found;
  compare_output(expected, actual, found);
  compare_messages(expected, actual, found);
  if (!expected.shown.empty() && expected.shown != actual.shown)
    found.push_back(fmt::format("expected to be shown:\n{}but it was:\n{}", join(expected.shown),
                                join(actual.shown)));
  if (const int want = expected_exit(expected); want != actual.exit)
    found.push_back(fmt::format("expected exit status {}, got {}", want, actual.exit));
  return found;
}

std::string update_expectations(std::string_view source, const Outcome& actual) {
  const Expectations old = parse_expectations(source);
  Stripped program = strip(split_lines(source));
  std::vector<std::string> at_end;
  const bool in_place = old.output.size() == actual.output.size();
  for (std::size_t i = 0; i < actual.output.size(); ++i) {
    std::string comment = "// expect: " + actual.output[i];
    if (in_place && old.output[i].within &&
        about_equal(old.output[i].text, actual.output[i], *old.output[i].within))
      comment =
          fmt::format("// expect about: {} within {}", old.output[i].text, *old.output[i].within);
    const auto lines = split_lines(source);
    const bool own_line = !in_place || comment_of(lines[old.output[i].line - 1])->code.empty();
    if (own_line)
      at_end.push_back(comment);
    else
      program.lines[program.kept[old.output[i].line] - 1] += "  " + comment;
  }
  for (const Message& message : actual.messages) {
    if (old.shown_only) break;
    const char* kind = message.code[0] == 'W' ? "advice" : "error";
    const std::string comment = fmt::format("  // expect {} {} at {}: {}", kind, message.code,
                                            message.column, message.text);
    if (program.kept.contains(message.line) && program.kept[message.line] > 0)
      program.lines[program.kept[message.line] - 1] += comment;
  }
  if (!old.shown.empty()) {
    at_end.push_back(old.shown_as.empty() ? "// expect shown:"
                                          : fmt::format("// expect shown as {}:", old.shown_as));
    for (const std::string& line : actual.shown) at_end.push_back("// | " + line);
  }
  return join(program.lines) + join(at_end);
}

}  // namespace armlet::test

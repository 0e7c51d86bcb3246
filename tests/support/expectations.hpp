#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armlet::test {

// What a script says about itself in its comments; see tests/README.md for their forms.
struct Expectations {
  struct Output {
    std::string text;
    std::optional<double> within;  // numbers may differ by this much; equal text without it
    int line = 0;                  // where the comment stands, from 1
  };
  struct Message {
    std::string code;  // "E0312"
    std::string text;  // part of the headline; may be empty
    int line = 0;      // the line that the main mark must be on
    int column = 0;    // 0: any
  };
  std::vector<Output> output;      // the lines of standard output, in order
  std::vector<Message> messages;   // every message and advice, in any order
  std::vector<std::string> shown;  // the whole rendered text of the messages; empty: not checked
  std::string shown_as;            // the name of the script in that text; empty: its own
  bool shown_only = false;         // that text alone states the messages
  std::optional<int> exit;         // without it 65 with an E expected, 70 with an R, else 0
  std::string command = "run";     // what stands between `armlet` and the file
};

// What a script did.
struct Outcome {
  std::vector<std::string> output;
  std::vector<Expectations::Message> messages;
  std::vector<std::string> shown;
  int exit = 0;
};

// Throws std::invalid_argument with the line number for a comment that starts like an expectation
// and is none.
Expectations parse_expectations(std::string_view source);

// The lines of `lines` that belong to messages, without reports of progress.
std::vector<std::string> only_messages(const std::vector<std::string>& lines);

int expected_exit(const Expectations& expected);

// One line for each difference; empty if the outcome is as expected.
std::vector<std::string> differences(const Expectations& expected, const Outcome& actual);

// The source with its expectations rewritten to fit the outcome. Output comments stay on their
// lines when their number has not changed; otherwise all go to the end of the file.
std::string update_expectations(std::string_view source, const Outcome& actual);

// Whether the two lines are the same but for numbers that differ by at most `within`.
bool about_equal(std::string_view expected, std::string_view actual, double within);

std::vector<std::string> split_lines(std::string_view text);

}  // namespace armlet::test

#pragma once
// Random programs that move robots: the same number is the same program everywhere.
//
// Two arms with cubes move, follow velocity commands, grasp and fail, in branches and under
// watches, with guards, settings, paths, recordings, signals, maps and records. Not every one runs
// to its end, nor is every command possible.

#include <cstdint>
#include <random>
#include <string>

namespace armlet::oracle {

class RobotProgram {
 public:
  explicit RobotProgram(std::uint64_t number) : random_(number * 0x9E3779B97F4A7C15ULL + 7) {}
  std::string text();

 private:
  // Which arms a block may command: another task may command the other.
  enum class Arms { kNone, kLeft, kRight, kBoth };

  std::size_t below(std::size_t n) { return random_() % n; }
  bool one_in(std::size_t n) { return below(n) == 0; }
  std::string arm_of(Arms arms);
  std::string between(double low, double high, const char* unit);
  std::string goal(const std::string& arm);

  void line(const std::string& text) { out_ += std::string(2 * depth_, ' ') + text + '\n'; }
  void open(const std::string& head) {
    line(head.empty() ? "{" : head + " {");
    ++depth_;
  }
  void close(const std::string& more = "") {
    --depth_;
    line("}" + more);
  }
  void block(Arms arms, std::size_t count);
  void statement(Arms arms);
  void act(const std::string& arm);
  void compute();
  void branches(Arms arms);
  void watch();
  void attempt(Arms arms);

  std::mt19937_64 random_;
  std::string out_;
  std::size_t depth_ = 0;
  std::size_t statements_left_ = 0;
  std::size_t names_ = 0;
};

}  // namespace armlet::oracle

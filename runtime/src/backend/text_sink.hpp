// A buffered stream for backends, independent of the locale, that stores failures.
#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <ostream>
#include <string>
#include <string_view>

namespace armlet {

class TextSink {
 public:
  explicit TextSink(std::ostream& out) : out_(&out) {}

  void text(std::string_view text) { buffer_.append(text); }

  // Writes a number with `digits` significant digits; 17 read back to the same bits. -0 becomes 0.
  void number(double value, int digits) {
    fmt::format_to(fmt::appender(buffer_), "{:.{}g}", value + 0.0, digits);
  }

  // Writes a number with the fewest digits that read back to the same number.
  void number(double value) { fmt::format_to(fmt::appender(buffer_), "{}", value + 0.0); }

  // Writes nanoseconds as seconds, exactly: "2.000000000".
  void seconds(std::int64_t t_ns) {
    constexpr std::int64_t kSecond = 1000000000;
    fmt::format_to(fmt::appender(buffer_), "{}.{:09d}", t_ns / kSecond, t_ns % kSecond);
  }

  // Writes text as a JSON string, with quotes and escapes.
  void quoted(std::string_view text);

  // Ends a line; writes the buffered text to the stream when there is much of it.
  void end_line();

  void flush_if_much();

  // Writes all buffered text to the stream.
  void flush();

  // Writes all buffered text to the stream and overwrites its first bytes, so the stream has to be
  // seekable; nothing can be added afterwards.
  void replace_beginning(std::string_view text);

  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  void check();

  std::ostream* out_;
  fmt::memory_buffer buffer_;
  std::string error_;
};

// Unit quaternion of the rotation whose first part (w, x, y, z) that is not zero is positive.
Eigen::Quaterniond positive_quaternion(const Eigen::Isometry3d& T);

}  // namespace armlet

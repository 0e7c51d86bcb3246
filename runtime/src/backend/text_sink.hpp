// A stream that backends write to: buffered, independent of the locale, remembers failure.
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

  // -0 is written as 0. `digits` significant digits; 17 read back to the same bits.
  void number(double value, int digits) {
    fmt::format_to(fmt::appender(buffer_), "{:.{}g}", value + 0.0, digits);
  }

  // The fewest digits that read back to the same number.
  void number(double value) { fmt::format_to(fmt::appender(buffer_), "{}", value + 0.0); }

  // Nanoseconds as seconds, exactly: "2.000000000".
  void seconds(std::int64_t t_ns) {
    constexpr std::int64_t kSecond = 1000000000;
    fmt::format_to(fmt::appender(buffer_), "{}.{:09d}", t_ns / kSecond, t_ns % kSecond);
  }

  // Text in double quotes as JSON wants it.
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

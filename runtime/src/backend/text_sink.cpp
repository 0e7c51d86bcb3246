#include "backend/text_sink.hpp"

#include <cmath>

namespace armlet {

void TextSink::quoted(std::string_view text) {
  buffer_.push_back('"');
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      buffer_.push_back('\\');
      buffer_.push_back(c);
    } else if (code < 0x20) {
      fmt::format_to(fmt::appender(buffer_), "\\u{:04x}", code);
    } else {
      buffer_.push_back(c);
    }
  }
  buffer_.push_back('"');
}

void TextSink::end_line() {
  buffer_.push_back('\n');
  flush_if_much();
}

void TextSink::flush_if_much() {
  constexpr std::size_t kMuch = 1 << 16;
  if (buffer_.size() >= kMuch) flush();
}

void TextSink::check() {
  if (!*out_) error_ = "The trace could not be written; is the disk full?";
}

void TextSink::flush() {
  // After a failure nothing more is written, so the output consists of complete lines.
  if (error_.empty()) {
    out_->write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    out_->flush();
    check();
  }
  buffer_.clear();
}

void TextSink::replace_beginning(std::string_view text) {
  flush();
  if (!error_.empty()) return;
  out_->seekp(0);
  out_->write(text.data(), static_cast<std::streamsize>(text.size()));
  out_->flush();
  check();
}

Eigen::Quaterniond positive_quaternion(const Eigen::Isometry3d& T) {
  Eigen::Quaterniond quaternion(T.linear());
  // For half a revolution w is 0 up to rounding; its sign must not change from sample to sample.
  for (const double part : {quaternion.w(), quaternion.x(), quaternion.y(), quaternion.z()}) {
    if (std::abs(part) < 1e-9) continue;
    if (part < 0.0) quaternion.coeffs() = -quaternion.coeffs();
    break;
  }
  return quaternion;
}

}  // namespace armlet

#include "armlet/interpreter/source.hpp"

#include <algorithm>
#include <utility>

namespace armlet {

Span cover(Span a, Span b) {
  return {std::min(a.begin, b.begin), std::max(a.end, b.end), a.source};
}

Source::Source(std::string name, std::string text, std::uint32_t id)
    : name_(std::move(name)), text_(std::move(text)), id_(id) {
  line_starts_.push_back(0);
  for (std::uint32_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
  }
}

Position Source::position(std::uint32_t offset) const {
  offset = std::min<std::uint32_t>(offset, static_cast<std::uint32_t>(text_.size()));
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto line = static_cast<int>(next - line_starts_.begin());
  int column = 1;
  for (std::uint32_t i = *(next - 1); i < offset; ++i) {
    // Bytes after the first one of a UTF-8 character do not count as columns.
    if ((static_cast<unsigned char>(text_[i]) & 0xC0U) != 0x80U) ++column;
  }
  return {line, column};
}

std::string_view Source::line(int line) const {
  if (line < 1 || line > line_count()) return {};
  const std::uint32_t begin = line_starts_[line - 1];
  std::uint32_t end =
      line < line_count() ? line_starts_[line] - 1 : static_cast<std::uint32_t>(text_.size());
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

std::uint32_t Source::line_start(int line) const {
  return line_starts_[std::clamp(line, 1, line_count()) - 1];
}

std::string_view Source::slice(Span span) const {
  const auto size = static_cast<std::uint32_t>(text_.size());
  const std::uint32_t begin = std::min(span.begin, size);
  return std::string_view(text_).substr(begin, std::min(span.end, size) - begin);
}

SourceSet::SourceSet(std::shared_ptr<const SourceSet> before) : before_(std::move(before)) {
  if (before_ == nullptr) return;
  first_ = static_cast<std::uint32_t>(before_->size());
  depth_ = before_->depth_ + 1;
  far_ = before_.get();
  const SourceSet* near = before_->far_;
  if (near != nullptr && near->far_ != nullptr &&
      before_->depth_ - near->depth_ == near->depth_ - near->far_->depth_)
    far_ = near->far_;
}

// The sources of earlier entries are destroyed one after the other. Otherwise each destructor would
// call the next one, as deep as the session is long.
SourceSet::~SourceSet() {
  std::shared_ptr<const SourceSet> last = std::move(before_);
  while (last != nullptr && last.use_count() == 1) last = std::exchange(last->before_, nullptr);
}

const Source& SourceSet::add(std::string name, std::string text) {
  sources_.push_back(std::make_unique<Source>(std::move(name), std::move(text),
                                              static_cast<std::uint32_t>(size())));
  return *sources_.back();
}

const Source& SourceSet::operator[](std::uint32_t id) const {
  const SourceSet* at = this;
  while (id < at->first_) at = id < at->far_->first_ ? at->far_ : at->before_.get();
  return *at->sources_[id - at->first_];
}

}  // namespace armlet

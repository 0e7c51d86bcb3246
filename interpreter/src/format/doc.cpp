#include "format/doc.hpp"

#include <algorithm>
#include <utility>

#include "base/cancelled.hpp"
#include "base/diagnostic/display_width.hpp"

namespace armlet::lang {
namespace {

// The mode of a group. In kFlat and kHug its lines are flat; inner groups are flat too in kFlat,
// and break independently in kHug.
enum class Mode : std::uint8_t { kFlat, kHug, kBroken };

struct Command {
  const Doc* doc;
  int indent;
  Mode mode;
};

class Printer {
 public:
  std::vector<OutLine> run(const Doc& doc, const std::atomic<bool>* cancelled) {
    lines_.emplace_back();
    pending_.push_back({&doc, 0, Mode::kBroken});
    while (!pending_.empty()) {
      stop_if(cancelled);
      const Command command = pending_.back();
      pending_.pop_back();
      print(command);
    }
    return std::move(lines_);
  }

 private:
  OutLine& now() { return lines_.back(); }

  void print(const Command& at) {
    const Doc& doc = *at.doc;
    switch (doc.kind) {
      case DocKind::kText:
        return put(doc.text);
      case DocKind::kBreak:
        return new_line(at.indent, doc.blank);
      case DocKind::kContinue:
        return new_line(at.indent + kIndentWidth, false);
      case DocKind::kRemark:
        return put_remark(doc);
      case DocKind::kColumn:
        if (now().column == 0) {
          now().column = doc.number;
          now().split = now().text.size();
          now().wide = doc.wide;
        }
        return;
      case DocKind::kLine:
        return at.mode == Mode::kBroken ? new_line(at.indent, false) : put(doc.text);
      case DocKind::kFillLine:
        if (at.mode != Mode::kBroken || fits({}, width() + text_width(doc.text)))
          return put(doc.text);
        return new_line(at.indent, false);
      case DocKind::kGroup:
        return push_parts(doc, at.indent, group_mode(doc, at));
      case DocKind::kIndent:
        return push_parts(doc, at.indent + doc.number, at.mode);
      case DocKind::kBody:
        return push_parts(doc, at.indent, Mode::kBroken);
      case DocKind::kConcat:
        return push_parts(doc, at.indent, at.mode);
    }
  }

  Mode group_mode(const Doc& doc, const Command& at) {
    const Mode mode = mode_to_measure(at);
    if (mode != Mode::kBroken || doc.forced) return mode;
    return fits({&doc, at.indent, Mode::kFlat}, width()) ? Mode::kFlat : Mode::kBroken;
  }

  // The mode of a group, or of a part in the position of a group, if it is known without measuring:
  // kBroken means that the group may break.
  static Mode mode_to_measure(const Command& at) {
    const Doc& doc = *at.doc;
    if (doc.kind == DocKind::kBody) return Mode::kBroken;
    if (doc.kind != DocKind::kGroup) return at.mode;
    if (at.mode == Mode::kFlat) return doc.forced ? Mode::kBroken : Mode::kFlat;
    return doc.hugs ? Mode::kHug : Mode::kBroken;
  }

  void push_parts(const Doc& doc, int indent, Mode mode) {
    for (auto part = doc.parts.rbegin(); part != doc.parts.rend(); ++part)
      pending_.push_back({&*part, indent, mode});
  }

  int width() { return (now().text.empty() ? now().indent : 0) + width_; }

  void put(std::string_view text) {
    if (text.empty()) return;
    if (now().text.empty()) width_ = now().indent;
    now().text += text;
    width_ =
        text.find('\n') == std::string_view::npos ? width_ + text_width(text) : text_width(text);
  }

  void put_remark(const Doc& doc) {
    if (!now().remark.empty()) {
      now().remark.append(" ").append(doc.text);
    } else {
      now().remark = doc.text;
      now().remark_column = doc.number;
    }
  }

  void new_line(int indent, bool blank) {
    if (blank) lines_.emplace_back();
    lines_.push_back({.indent = indent});
    width_ = 0;
  }

  // Whether `first` and the parts after it, up to the next line break, fit the line after `used`
  // columns.
  bool fits(Command first, int used) {
    std::vector<Command> inside;
    if (first.doc != nullptr) {
      for (auto part = first.doc->parts.rbegin(); part != first.doc->parts.rend(); ++part)
        inside.push_back({&*part, 0, Mode::kFlat});
    }
    std::size_t rest = pending_.size();
    while (used <= kLineWidth) {
      if (inside.empty()) {
        if (rest == 0) return true;
        inside.push_back(pending_[--rest]);
      }
      const Command at = inside.back();
      inside.pop_back();
      const Doc& doc = *at.doc;
      switch (doc.kind) {
        case DocKind::kText:
          used += text_width(doc.text.substr(0, doc.text.find('\n')));
          if (doc.text.find('\n') != std::string_view::npos) return used <= kLineWidth;
          break;
        case DocKind::kBreak:
        case DocKind::kContinue:
          return true;
        case DocKind::kLine:
        case DocKind::kFillLine:
          if (at.mode == Mode::kBroken) return true;
          used += text_width(doc.text);
          break;
        case DocKind::kRemark:  // a comment of this kind may be in the middle of a line
          if (doc.text.starts_with("/*")) used += 1 + text_width(doc.text);
          break;
        case DocKind::kColumn:
          break;
        case DocKind::kConcat:
        case DocKind::kGroup:
        case DocKind::kIndent:
        case DocKind::kBody: {
          const Mode mode = mode_to_measure(at);
          for (auto part = doc.parts.rbegin(); part != doc.parts.rend(); ++part)
            inside.push_back({&*part, 0, mode});
        }
      }
    }
    return false;
  }

  std::vector<OutLine> lines_;
  std::vector<Command> pending_;
  int width_ = 0;
};

}  // namespace

void Doc::add(Doc part) {
  forced = forced || part.forced;
  body = body || part.body;
  parts.push_back(std::move(part));
}

Doc text(std::string_view text) { return {.kind = DocKind::kText, .text = text}; }

Doc line(std::string_view flat) { return {.kind = DocKind::kLine, .text = flat}; }

Doc hard_break(bool blank) { return {.kind = DocKind::kBreak, .blank = blank}; }

Doc indent(Doc inner, int columns) {
  Doc out{.kind = DocKind::kIndent, .number = columns};
  out.add(std::move(inner));
  return out;
}

Doc group(Doc inner) {
  Doc out{.kind = DocKind::kGroup};
  out.hugs = inner.body;
  out.add(std::move(inner));
  return out;
}

Doc body(Doc inner, bool may_be_flat) {
  Doc out{.kind = may_be_flat ? DocKind::kGroup : DocKind::kBody};
  out.add(std::move(inner));
  out.forced = false;
  out.body = true;
  return out;
}

std::vector<OutLine> print(const Doc& doc, const std::atomic<bool>* cancelled) {
  return Printer().run(doc, cancelled);
}

int text_width(std::string_view text) {
  if (const std::size_t at = text.rfind('\n'); at != std::string_view::npos)
    text.remove_prefix(at + 1);
  const bool plain = std::ranges::all_of(text, [](char c) { return c >= 0x20 && c < 0x7F; });
  return plain ? static_cast<int>(text.size()) : display_line(text).columns.back();
}

}  // namespace armlet::lang

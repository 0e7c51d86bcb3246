#include "format/layout.hpp"

#include "base/cancelled.hpp"

namespace armlet::lang {
namespace {

bool opens(std::string_view text) { return text == "(" || text == "[" || text == "{"; }

// Whether a mark directly follows the text before it, even if that is a comment.
bool clings(std::string_view text) {
  return text == ")" || text == "]" || text == "," || text == ";" || text == "." || text == "(" ||
         text == "[";
}

}  // namespace

std::string_view Layout::text_of(std::uint32_t token) const {
  const Token& at = shape_.tokens[token];
  return source_.text().substr(at.begin, at.end - at.begin);
}

bool Layout::is(const ShapeNode& node, std::string_view text) const {
  return node.rule == Rule::kToken && !shape_.tokens[node.token].inserted &&
         text_of(node.token) == text;
}

// The index of the part that closes the bracket at part `open`. The parts between the two are nodes
// of their own.
std::size_t Layout::closing_part(const ShapeNode& node, std::size_t open) const {
  const std::string_view opener = text_of(node.parts[open].token);
  const std::string_view closer = opener == "(" ? ")" : opener == "[" ? "]" : "}";
  std::size_t close = open + 1;
  while (!is(node.parts[close], closer)) ++close;
  return close;
}

std::uint32_t Layout::last_token(const ShapeNode& node) const {
  const ShapeNode* at = &node;
  while (at->rule != Rule::kToken) at = &at->parts.back();
  return at->token;
}

bool Layout::on_one_line(std::uint32_t first, std::uint32_t last) const {
  const std::uint32_t begin = shape_.tokens[first].begin;
  const std::uint32_t end = shape_.tokens[last].end;
  return source_.text().substr(begin, end - begin).find_first_of("\r\n") == std::string_view::npos;
}

bool Layout::on_one_line(const ShapeNode& node) const {
  return on_one_line(node.token, last_token(node));
}

// A line break that a comment needs. If no break was planned there, the new line is indented.
Doc Layout::comment_break(Lead lead, bool blank) const {
  Doc out = hard_break(blank && (lead == Lead::kBreak || lead == Lead::kFirstBreak));
  if (lead == Lead::kTight || lead == Lead::kSpace) out.kind = DocKind::kContinue;
  out.forced = true;
  return out;
}

Doc Layout::lead_of(std::uint32_t token, Lead lead) const {
  if (lead == Lead::kDone) return {};
  const Gap& gap = gaps_[token];
  const auto planned = [&] {
    switch (lead) {
      case Lead::kDone:
      case Lead::kTight:
        return Doc{};
      case Lead::kSpace:
        return text(" ");
      case Lead::kSoft:
        return line("");
      case Lead::kLine:
        return line(" ");
      case Lead::kFill:
        return Doc{.kind = DocKind::kFillLine, .text = " "};
      case Lead::kBreak:
      case Lead::kFirstBreak:
        break;
    }
    return hard_break(lead == Lead::kBreak && gap.breaks_before > 1);
  };
  if (gap.comments.empty()) return planned();
  const auto may_be_blank = [&](std::size_t i) { return lead != Lead::kFirstBreak || i > 0; };
  Doc out;
  for (std::size_t i = 0; i < gap.comments.size(); ++i) {
    const Comment& comment = gap.comments[i];
    if (i < gap.at_end) {
      out.add({.kind = DocKind::kRemark, .text = comment.text, .number = comment.column});
      continue;
    }
    if (comment.breaks_before > 0) {
      out.add(comment_break(lead, comment.breaks_before > 1 && may_be_blank(i)));
    } else if (i > 0) {
      out.add(text(" "));
    } else if (lead == Lead::kTight && token > 0 && !opens(text_of(token - 1))) {
      out.add(text(" "));
    } else {
      out.add(planned());
    }
    out.add(text(comment.text));
  }
  if (gap.breaks_before > 0) {
    out.add(comment_break(lead, gap.breaks_before > 1));
  } else if (lead != Lead::kTight || !clings(text_of(token))) {
    out.add(text(" "));
  }
  return out;
}

Doc Layout::token(std::uint32_t token, Lead lead) const {
  if (shape_.tokens[token].inserted) return {};
  Doc out;
  out.add(lead_of(token, lead));
  out.add(text(text_of(token)));
  return out;
}

// The comments before a closing bracket, as lines inside of the brackets.
Doc Layout::comments_at_end(std::uint32_t closer, bool with_blanks) const {
  const Gap& gap = gaps_[closer];
  Doc out;
  for (std::size_t i = 0; i < gap.comments.size(); ++i) {
    const Comment& comment = gap.comments[i];
    if (i < gap.at_end) {
      out.add({.kind = DocKind::kRemark, .text = comment.text, .number = comment.column});
    } else if (comment.breaks_before > 0) {
      out.add(comment_break(Lead::kBreak, comment.breaks_before > 1 && (with_blanks || i > 0)));
      out.add(text(comment.text));
    } else {
      if (i > 0 || (closer > 0 && !opens(text_of(closer - 1)))) out.add(text(" "));
      out.add(text(comment.text));
    }
  }
  out.forced = out.forced || (!gap.comments.empty() && gap.has_break());
  return out;
}

// A closing bracket whose comments were moved inside.
Doc Layout::token_without_comments(std::uint32_t closer, Lead lead) const {
  const Gap& gap = gaps_[closer];
  Doc out;
  if (lead == Lead::kFirstBreak || (!gap.comments.empty() && gap.has_break())) {
    out.add(hard_break());
  } else {
    out.add(line(lead == Lead::kLine ? " " : ""));
  }
  out.add(text(text_of(closer)));
  return out;
}

// Begins a part that may be aligned with neighbouring lines.
Doc Layout::column(std::uint32_t token) const {
  const std::uint32_t begin = shape_.tokens[token].begin;
  const std::uint32_t blanks = begin - shape_.tokens[token - 1].end;
  return {.kind = DocKind::kColumn,
          .number = display_column(source_, begin),
          .wide = blanks > 1 && gaps_[token].comments.empty() && !gaps_[token].has_break()};
}

Doc Layout::node(const ShapeNode& node, Lead lead, bool is_value) {
  stop_if(cancelled_);
  if (node.rule == Rule::kToken) return token(node.token, lead);
  if (node.rule == Rule::kBlock) return braces(node, 0, lead, Braces::kAsWritten);
  if (node.rule == Rule::kIfStmt) return if_statement(node, lead);
  if (node.rule == Rule::kTryStmt) return try_statement(node, lead);
  if (node.rule == Rule::kSwitchCase) return switch_case(node, lead);
  if (node.rule == Rule::kExpression || node.rule == Rule::kExpr) return expression(node, lead);
  return sequence(node, lead, is_value);
}

// Whether part `i` is the whole value of its line, after `=` or `:`.
bool Layout::holds_value(const ShapeNode& node, std::size_t i) const {
  if (i == 0 || in_header_) return false;
  if (node.rule == Rule::kBlockItem) return is(node.parts[i - 1], ":");
  return is(node.parts[i - 1], "=") && node.rule != Rule::kParam;
}

Doc Layout::sequence(const ShapeNode& node, Lead lead, bool is_value) {
  Doc out;
  for (std::size_t i = 0; i < node.parts.size(); ++i) {
    const ShapeNode& part = node.parts[i];
    const Lead before = i == 0 ? lead : between(node, i);
    if (is(part, "{") && node.rule != Rule::kBraceInit) {
      if (node.rule == Rule::kBlockDecl) out.add(column(part.token));
      out.add(braces(node, i, before, Braces::kAsWritten));
      i = closing_part(node, i);
    } else if (is(part, "(") || (is(part, "[") && !is_one_word(node)) || is(part, "{")) {
      const bool is_header = node.rule >= Rule::kWhileStmt && node.rule <= Rule::kRecordStmt;
      out.add(is_header ? header(node, i, before) : brackets(node, i, before, is_value));
      i = closing_part(node, i);
    } else if ((node.rule == Rule::kWhileStmt || node.rule == Rule::kForStmt) &&
               i + 1 == node.parts.size()) {
      out.add(body_of(part, Braces::kAsWritten));
    } else {
      if (is(part, "=") && (node.rule == Rule::kLetDecl || node.rule == Rule::kDeclarator))
        out.add(column(part.token));
      out.add(this->node(part, before,
                         holds_value(node, i) || (is_value && node.rule == Rule::kNewArray)));
    }
  }
  return out;
}

}  // namespace armlet::lang

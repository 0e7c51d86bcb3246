// The layout of statements: braces, headers, and statements on one line.

#include <utility>

#include "format/layout.hpp"

namespace armlet::lang {
Doc Layout::program() {
  Doc out = statements(shape_.program, 0, shape_.program.parts.size(), Lead::kBreak);
  out.add(comments_at_end(static_cast<std::uint32_t>(shape_.tokens.size() - 1), true));
  return body(std::move(out), false);
}

// The parts from `from` to before `to`, separated by `between`. The end of a statement directly
// follows it.
Doc Layout::statements(const ShapeNode& node, std::size_t from, std::size_t to, Lead between) {
  Doc out;
  const bool in_braces = node.rule != Rule::kProgram;
  bool first = true;
  for (std::size_t i = from; i < to; ++i) {
    const ShapeNode& part = node.parts[i];
    if (part.rule == Rule::kToken && shape_.tokens[part.token].inserted) continue;
    Lead lead = first && in_braces && between == Lead::kBreak ? Lead::kFirstBreak : between;
    if (!first && (is(part, ";") || is(part, ","))) lead = Lead::kTight;
    out.add(this->node(part, lead));
    first = false;
  }
  return out;
}

// Moves comments between a statement and its brace to the line after the brace.
bool Layout::move_comments_inside(std::uint32_t brace) {
  Gap& before = gaps_[brace];
  Gap& inside = gaps_[brace + 1];
  if (before.comments.empty() || !before.has_break()) return false;
  // On a line of its own such a comment would become the documentation of the next statement.
  for (std::size_t i = 0; i < inside.at_end; ++i) {
    if (inside.comments[i].text.starts_with("///")) return false;
  }
  int& breaks = inside.comments.empty() ? inside.breaks_before : inside.comments[0].breaks_before;
  breaks = std::max(breaks, 1);
  inside.at_end = before.at_end;
  inside.comments.insert(inside.comments.begin(), before.comments.begin(), before.comments.end());
  before = {};
  return true;
}

// The part from the brace at part `open` to its closing brace.
Doc Layout::braces(const ShapeNode& node, std::size_t open, Lead lead, Braces style) {
  const std::size_t close = closing_part(node, open);
  const std::uint32_t opener = node.parts[open].token;
  const std::uint32_t closer = node.parts[close].token;
  const bool moved = lead == Lead::kSpace && move_comments_inside(opener);
  const bool flat = style != Braces::kOpen && !moved && on_one_line(opener, closer);
  Doc out;
  out.add(token(opener, lead));
  const bool before = std::exchange(in_header_, false);
  Doc inner = statements(node, open + 1, close, flat ? Lead::kLine : Lead::kBreak);
  in_header_ = before;
  const bool is_empty = inner.parts.empty() && gaps_[closer].comments.empty();
  if (inner.parts.empty() && !is_empty && gaps_[closer].at_end == 0 &&
      gaps_[closer].comments[0].breaks_before == 0) {
    inner.add(flat ? line(" ") : hard_break());
  }
  inner.add(comments_at_end(closer, !inner.parts.empty()));
  if (is_empty) {
    out.add(token(closer, Lead::kTight));
    return out;
  }
  Doc lines;
  lines.add(indent(std::move(inner)));
  lines.add(token_without_comments(closer, flat ? Lead::kLine : Lead::kFirstBreak));
  if (flat && style == Braces::kShared) {
    out.add(std::move(lines));
    out.body = true;
    return out;
  }
  out.add(body(std::move(lines), flat));
  return out;
}

// The parentheses after `if`, `while` and similar words.
Doc Layout::header(const ShapeNode& node, std::size_t open, Lead lead) {
  const std::size_t close = closing_part(node, open);
  const bool before = std::exchange(in_header_, true);
  Doc inner;
  for (std::size_t i = open + 1; i < close; ++i) {
    const ShapeNode& part = node.parts[i];
    if (part.rule == Rule::kForHeader) {
      inner.add(for_header(part));
    } else {
      inner.add(this->node(part, Lead::kTight));
    }
  }
  in_header_ = before;
  Doc out;
  out.add(token(node.parts[open].token, lead));
  out.add(std::move(inner));
  out.add(token(node.parts[close].token, Lead::kTight));
  return out;
}

// The header of a loop: int i = 0; i < n; i++
Doc Layout::for_header(const ShapeNode& node) {
  Doc out;
  for (std::size_t i = 0; i < node.parts.size(); ++i) {
    Lead lead = i == 0 ? Lead::kTight : between(node, i);
    if (i > 0 && is(node.parts[i - 1], ";") && !is(node.parts[i], ";")) lead = Lead::kLine;
    out.add(this->node(node.parts[i], lead));
  }
  return group(indent(std::move(out), chain_indent()));
}

// The body after a header or an `else`.
Doc Layout::body_of(const ShapeNode& node, Braces style) {
  if (node.rule == Rule::kBlock) return braces(node, 0, Lead::kSpace, style);
  if (node.rule == Rule::kToken) return token(node.token, Lead::kTight);
  const bool same_line = !gaps_[node.token].has_break();
  if (style == Braces::kShared) return indent(this->node(node, Lead::kLine));
  if (!same_line) return indent(this->node(node, Lead::kFirstBreak));
  return group(indent(this->node(node, Lead::kLine)));
}

Doc Layout::if_statement(const ShapeNode& node, Lead lead) {
  const bool has_else = is(node.parts[node.parts.size() - 2], "else");
  const bool flat = has_else && on_one_line(node);
  Doc out;
  out.add(token(node.token, lead));
  Doc parts = if_parts(node, flat       ? Braces::kShared
                             : has_else ? Braces::kOpen
                                        : Braces::kAsWritten);
  out.add(flat ? body(std::move(parts), true) : std::move(parts));
  // Also if the statement has several lines, so that the layout around it is the same.
  out.body = out.body || has_else;
  return out;
}

// The space before `else`, `catch` and `finally`, after a brace.
Lead Layout::behind_brace(std::uint32_t token) const {
  const Gap& gap = gaps_[token];
  return !gap.comments.empty() && gap.has_break() ? Lead::kFirstBreak : Lead::kSpace;
}

// The parts after the word `if`.
Doc Layout::if_parts(const ShapeNode& node, Braces style) {
  Doc out;
  out.add(header(node, 1, Lead::kSpace));
  out.add(body_of(node.parts[4], style));
  if (node.parts.size() == 5) return out;
  const ShapeNode& otherwise = node.parts[6];
  const std::uint32_t word = node.parts[5].token;
  const Lead lead = node.parts[4].rule == Rule::kBlock ? behind_brace(word)
                    : style == Braces::kShared         ? Lead::kLine
                                                       : Lead::kFirstBreak;
  out.add(token(word, lead));
  if (otherwise.rule == Rule::kIfStmt) {
    out.add(token(otherwise.token, Lead::kSpace));
    out.add(if_parts(otherwise, style));
  } else {
    out.add(body_of(otherwise, style));
  }
  return out;
}

Doc Layout::try_statement(const ShapeNode& node, Lead lead) {
  const bool flat = on_one_line(node);
  const Braces style = flat ? Braces::kShared : Braces::kOpen;
  Doc parts;
  for (std::size_t i = 1; i < node.parts.size(); ++i) {
    const ShapeNode& part = node.parts[i];
    if (part.rule == Rule::kBlock) {
      parts.add(braces(part, 0, Lead::kSpace, style));
    } else if (part.rule == Rule::kCatchClause) {
      parts.add(token(part.token, behind_brace(part.token)));
      if (part.parts.size() > 2) parts.add(header(part, 1, Lead::kSpace));
      parts.add(braces(part.parts.back(), 0, Lead::kSpace, style));
    } else {
      parts.add(token(part.token, behind_brace(part.token)));
    }
  }
  Doc out;
  out.add(token(node.token, lead));
  out.add(flat ? body(std::move(parts), true) : std::move(parts));
  return out;
}

// case 1, 2: with its statements, on the same line if they were there in the text.
Doc Layout::switch_case(const ShapeNode& node, Lead lead) {
  Doc out;
  std::size_t at = 0;
  do {
    out.add(this->node(node.parts[at], at == 0 ? lead : between(node, at)));
  } while (!is(node.parts[at++], ":"));
  const bool flat = on_one_line(node.parts[at - 1].token, last_token(node));
  Doc inner = statements(node, at, node.parts.size(), flat ? Lead::kLine : Lead::kBreak);
  if (!inner.parts.empty()) out.add(body(indent(std::move(inner)), flat));
  return out;
}

}  // namespace armlet::lang

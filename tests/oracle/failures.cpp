// What fails, with the words and lines of the reference (sections 11 and 20).

#include "armlet/interpreter/messages/catalog.hpp"
#include "evaluator.hpp"
#include "show.hpp"

namespace armlet::oracle {

namespace {

// The text of a calculation in backquotes, if it is short enough to be read.
std::string in_backquotes(const std::string& text, const std::string& otherwise) {
  const bool is_short = !text.empty() && text.size() <= 40 && text.find('\n') == std::string::npos;
  return is_short ? "`" + text + "`" : otherwise;
}

int field_index(const Type& error, const char* name) { return error.record->index_of(name); }

}  // namespace

std::string Evaluator::text(Span span) const {
  return span.empty() ? std::string() : std::string(sources_.slice(span));
}

void Evaluator::fail(const Headline& headline, Span where) const {
  const CatalogEntry& row = *headline.row();
  throw Failure{std::string(row.code), headline.text(), std::string(row.kind), where};
}

void Evaluator::fail_index(std::int64_t index, std::size_t size, Span where,
                           const std::string& what) const {
  const std::string number = std::to_string(index);
  std::string message = what + " index " + number + " is outside 0 to " + std::to_string(size - 1);
  if (size == 0 && (what == "row" || what == "column")) {
    throw Failure{"R0606", "there is no " + what + " " + number + " in this matrix", "IndexError",
                  where};
  }
  if (size == 0 && index == -1 && (what == "list" || what == "text"))
    throw Failure{"R0606", "an empty " + what + " has no last value", "IndexError", where};
  if (size == 0) message = "there is no value " + number + " in an empty " + what;
  throw Failure{"R0606", message, "IndexError", where};
}

void Evaluator::fail_backwards(std::int64_t first, std::int64_t last, Span where) const {
  throw Failure{"R0606",
                "a part that starts at " + std::to_string(first) + " cannot end before " +
                    std::to_string(last),
                "IndexError", where};
}

void Evaluator::fail_calculation(Trouble trouble, Span where, const Value* a,
                                 const Value* b) const {
  switch (trouble) {
    case Trouble::kOverflow:
      fail("R0610", where, {in_backquotes(text(where), "this calculation")});
    case Trouble::kDivisionByZero:
      fail("R0611", where, {in_backquotes(text(where), "this")});
    case Trouble::kNegativeExponent:
      fail(
          "R0609", where,
          {"a power", std::to_string(b->integer()), "whole numbers need an exponent of 0 or more"});
    case Trouble::kFractionalPower:
      fail("R0609", where,
           {"a power with exponent " + show_number(b->real()), show_number(a->real()),
            "a negative number has only whole powers"});
    case Trouble::kNotFinite:
      fail("R0612", where, {"the value", show_number(a->real())});
  }
  throw std::logic_error("an unknown trouble");
}

Value Evaluator::calculate_at(lang::hir::Op op, const Value& a, const Value& b, Span where) const {
  try {
    return calculate(op, a, b);
  } catch (const TroubleError& e) {
    fail_calculation(e.trouble, where, &a, &b);
  }
}

// ---- error records

Value Evaluator::error_record(const std::string& message, const std::string& kind, int line,
                              double time) const {
  const Type& type = *program_->library_record("error");
  Record record;
  record.fields.resize(type.record->fields.size());
  record.fields[field_index(type, "message")] = {message};
  record.fields[field_index(type, "kind")] = {kind};
  record.fields[field_index(type, "robot")] = {std::string()};
  record.fields[field_index(type, "line")] = {std::int64_t{line}};
  record.fields[field_index(type, "time")] = {time};
  return {std::move(record)};
}

// Errors come to somebody's notice before any time passes.
Failure Evaluator::seen(const Failure& failure) const {
  Failure out = failure;
  if (out.time_ns < 0) out.time_ns = tasks_.now_ns();
  return out;
}

Value Evaluator::caught(const Failure& failure) const {
  const int line = failure.where.empty() ? 0 : sources_.position(failure.where).line;
  Value out = error_record(failure.message, failure.kind, line,
                           static_cast<double>(failure.time_ns) * 1e-9);
  out.record().failure = std::make_shared<const Failure>(failure);
  return out;
}

std::string Evaluator::error_field(const Value& error, const char* name) const {
  return error.record().fields[field_index(*program_->library_record("error"), name)].text();
}

Value Evaluator::error(const lang::hir::ErrorExpr& e) {
  const Value message = evaluate(*e.message);
  const std::string kind = e.kind_text == nullptr ? "" : evaluate(*e.kind_text).text();
  return error_record(message.text(), kind, sources_.position(e.span).line,
                      static_cast<double>(tasks_.now_ns()) * 1e-9);
}

void Evaluator::throw_error(const lang::hir::ThrowStmt& s) {
  const Value error = evaluate(*s.value);
  if (error.record().failure != nullptr) throw Failure(*error.record().failure);
  const std::string kind = error_field(error, "kind");
  const CatalogEntry* row = MessageTables().of_kind(kind);
  throw Failure{std::string(row == nullptr ? "R0627" : row->code), error_field(error, "message"),
                kind, s.span};
}

// ---- assertions

void Evaluator::check(const lang::hir::AssertStmt& s) {
  for (const lang::hir::InitStmt* part : s.parts_init) (void)execute(*part);
  if (evaluate(*s.condition).truth()) return;
  if (s.note != nullptr) (void)evaluate(*s.note);
  fail("R0608", s.condition_span, {std::string(s.text)});
}

void Evaluator::check_throws(const lang::hir::AssertThrowsStmt& s) {
  const std::optional<Value> wanted =
      s.kind_text == nullptr ? std::nullopt : std::optional(evaluate(*s.kind_text));
  const Aside aside(*this);
  try {
    (void)evaluate(*s.call);
  } catch (const Failure& failure) {
    aside.go_back();
    if (!wanted || wanted->text() == failure.kind) return;
    fail("R0608", s.call_span, {text(s.call_span) + " throws kind \"" + wanted->text() + "\""});
  }
  fail("R0608", s.call_span, {text(s.call_span) + " throws"});
}

}  // namespace armlet::oracle

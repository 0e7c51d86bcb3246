#include "vision/picture_rules.hpp"

#include <memory>

namespace armlet::bind {
namespace {

class KindFact : public Fact {
 public:
  explicit KindFact(PixelKind kind) : kind_(kind) {}
  [[nodiscard]] std::string_view kind() const override {
    return kind_ == PixelKind::kGrey ? "grey" : kind_ == PixelKind::kDepth ? "depths" : "";
  }

 private:
  PixelKind kind_;
};

}  // namespace

void note_kind(CheckCall& call, PixelKind kind) {
  call.set_result_fact(std::make_shared<KindFact>(kind));
}

void note_same_kind(CheckCall& call, CallPart part) {
  if (const auto fact = std::dynamic_pointer_cast<const KindFact>(call.fact(part)))
    call.set_result_fact(fact);
}

}  // namespace armlet::bind

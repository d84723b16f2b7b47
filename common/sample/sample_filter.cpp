#include "common/sample/sample_filter.hpp"

#include "common/sample/field_values.hpp"
#include "common/sample/filter_parser.hpp"

namespace scarab::sample {

class SampleFilter::Condition {
 public:
  Condition(const TypeModel& model, ParsedFilter parsed)
      : condition_(std::move(parsed.condition)), fields_(model, std::move(parsed.fields)) {}

  bool holds_for(ByteView cdr) const { return holds(condition_, fields_.read(cdr)); }

 private:
  FilterCondition condition_;
  FieldValues fields_;
};

SampleFilter::SampleFilter(const TypeModel& model, const std::string& expression)
    : condition_(std::make_unique<const Condition>(model, parse_filter(model, expression))) {}

SampleFilter::SampleFilter(SampleFilter&&) noexcept = default;
SampleFilter& SampleFilter::operator=(SampleFilter&&) noexcept = default;
SampleFilter::~SampleFilter() = default;

bool SampleFilter::matches(ByteView cdr) const { return condition_->holds_for(cdr); }

}  // namespace scarab::sample

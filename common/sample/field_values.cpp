#include "common/sample/field_values.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

namespace scarab::sample {

namespace {

/// Knows of each path how many of its steps lead to where the walk is.
class Collector : public SampleVisitor {
 public:
  explicit Collector(const std::vector<FieldPath>& paths) : values_(paths.size()) {
    for (const FieldPath& path : paths) follow_.push_back({&path, 0});
  }

  void begin_struct(const StructType&) override { enter({false, 0, {}}); }
  void member(const std::string& name) override { open_.back().member = name; }
  void end_struct() override { leave(); }
  void begin_list(std::size_t size, bool) override {
    enter({true, 0, {}});
    for (std::size_t i = 0; i < follow_.size(); ++i) {
      const Follow& follow = follow_[i];
      if (follow.path->is_length() && arrived(follow)) values_[i] = std::uint64_t{size};
    }
  }
  void end_list() override { leave(); }
  void scalar(const Scalar& value) override {
    for (std::size_t i = 0; i < follow_.size(); ++i) {
      const Follow& follow = follow_[i];
      const bool last = follow.steps + 1 == follow.path->steps().size();
      if (last && leads_on(follow)) values_[i] = value;
    }
    next();
  }

  std::vector<std::optional<Scalar>> take() { return std::move(values_); }

 private:
  struct Open {
    bool is_list;
    std::size_t element;  ///< of a list: the one that comes next
    std::string_view member;
  };
  struct Follow {
    const FieldPath* path;
    std::size_t steps;  ///< that lead here
  };

  /// The steps lead to the part that has just been entered, and there are no more.
  bool arrived(const Follow& follow) const {
    return follow.steps + 1 == open_.size() && follow.steps == follow.path->steps().size();
  }

  /// The steps lead to the open part, and the next one to the value that comes now.
  bool leads_on(const Follow& follow) const {
    const auto& steps = follow.path->steps();
    if (follow.steps + 1 != open_.size() || follow.steps >= steps.size()) return false;
    const FieldPath::Step& step = steps[follow.steps];
    const Open& in = open_.back();
    return in.is_list ? step.element == in.element : step.member == in.member;
  }

  void enter(const Open& part) {
    if (!open_.empty()) {
      for (Follow& follow : follow_) {
        if (leads_on(follow)) ++follow.steps;
      }
    }
    open_.push_back(part);
  }

  void leave() {
    open_.pop_back();
    const std::size_t depth = open_.empty() ? 0 : open_.size() - 1;
    for (Follow& follow : follow_) follow.steps = std::min(follow.steps, depth);
    next();
  }

  /// The value that came was an element, perhaps.
  void next() {
    if (!open_.empty() && open_.back().is_list) ++open_.back().element;
  }

  std::vector<Follow> follow_;
  std::vector<Open> open_;
  std::vector<std::optional<Scalar>> values_;
};

}  // namespace

FieldValues::FieldValues(TypeModel model, std::vector<FieldPath> paths)
    : model_(std::move(model)), paths_(std::move(paths)) {
  for (const FieldPath& path : paths_) {
    if (!path.is_scalar()) throw Error(path.text() + " is not one value");
  }
}

std::vector<std::optional<Scalar>> FieldValues::read(ByteView cdr) const {
  Collector collector(paths_);
  visit_sample(model_, cdr, collector);
  return collector.take();
}

}  // namespace scarab::sample

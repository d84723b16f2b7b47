#include "common/sample/sample_tree.hpp"

namespace scarab::sample {

namespace {

/// Keeps the nodes that are being filled on a stack; a finished one moves into the one below.
class TreeBuilder : public SampleVisitor {
 public:
  void begin_struct(const StructType& type) override {
    SampleNode::Struct members;
    members.reserve(type.members.size());
    open_.push_back({{std::move(members)}, {}});
  }
  void member(const std::string& name) override { open_.back().member = name; }
  void end_struct() override { close(); }
  void begin_list(std::size_t size, bool) override {
    SampleNode::List elements;
    elements.reserve(size);
    open_.push_back({{std::move(elements)}, {}});
  }
  void end_list() override { close(); }
  void scalar(const Scalar& value) override { add({value}); }

  SampleNode take() { return std::move(root_); }

 private:
  struct Open {
    SampleNode node;
    std::string_view member;  ///< of a struct: the name the next value gets
  };

  void close() {
    SampleNode done = std::move(open_.back().node);
    open_.pop_back();
    add(std::move(done));
  }

  void add(SampleNode node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& into = open_.back();
    if (auto* list = std::get_if<SampleNode::List>(&into.node.value)) {
      list->push_back(std::move(node));
    } else {
      std::get<SampleNode::Struct>(into.node.value).emplace_back(into.member, std::move(node));
    }
  }

  std::vector<Open> open_;
  SampleNode root_;
};

}  // namespace

SampleNode sample_tree(const TypeModel& model, ByteView cdr) {
  TreeBuilder builder;
  visit_sample(model, cdr, builder);
  return builder.take();
}

}  // namespace scarab::sample

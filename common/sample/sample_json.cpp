#include "common/sample/sample_json.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "common/sample/quoted_text.hpp"

namespace scarab::sample {
namespace {

struct AppendScalar {
  std::string& out;

  void operator()(bool value) const { out += value ? "true" : "false"; }
  void operator()(char value) const { append_quoted(out, character_text(value)); }
  void operator()(std::string_view value) const { append_quoted(out, value); }
  void operator()(const EnumValue& value) const {
    if (value.name != nullptr) {
      append_quoted(out, *value.name);
    } else {
      append_quoted(out, std::to_string(value.value));
    }
  }
  void operator()(std::int64_t value) const { number(value); }
  void operator()(std::uint64_t value) const { number(value); }
  void operator()(float value) const { real(value); }
  void operator()(double value) const { real(value); }

  template <class Number>
  void number(Number value) const {
    std::array<char, 32> buffer;
    out.append(buffer.data(), std::to_chars(buffer.begin(), buffer.end(), value).ptr);
  }
  /// JSON has no word for what is not finite.
  template <class Real>
  void real(Real value) const {
    const bool finite = std::isfinite(value);
    if (!finite) out += '"';
    number(value);
    if (!finite) out += '"';
  }
};

/// As in JSON, but for quotes.
struct AppendPlain {
  std::string& out;

  void operator()(char value) const { out += character_text(value); }
  void operator()(std::string_view value) const { out += value; }
  void operator()(const EnumValue& value) const {
    out += value.name != nullptr ? *value.name : std::to_string(value.value);
  }
  void operator()(float value) const { AppendScalar{out}.number(value); }
  void operator()(double value) const { AppendScalar{out}.number(value); }
  template <class Other>
  void operator()(Other value) const {
    AppendScalar{out}(value);
  }
};

class JsonWriter : public SampleVisitor {
 public:
  explicit JsonWriter(std::string& out) : out_(out) {}

  void begin_struct(const StructType&) override { open('{'); }
  void member(const std::string& name) override {
    separate();
    append_quoted(out_, name);
    out_ += ": ";
    first_ = true;  // its value follows without a comma
  }
  void end_struct() override { close('}'); }
  void begin_list(std::size_t, bool) override { open('['); }
  void end_list() override { close(']'); }
  void scalar(const Scalar& value) override {
    separate();
    std::visit(AppendScalar{out_}, value);
  }

 private:
  void separate() {
    if (!first_) out_ += ", ";
    first_ = false;
  }
  void open(char bracket) {
    separate();
    out_ += bracket;
    first_ = true;
  }
  void close(char bracket) {
    out_ += bracket;
    first_ = false;
  }

  std::string& out_;
  bool first_ = true;
};

}  // namespace

void append_json(std::string& out, const TypeModel& type, ByteView cdr) {
  JsonWriter writer(out);
  visit_sample(type, cdr, writer);
}

void append_json(std::string& out, const SampleNode& part) {
  const char* separator = "";
  if (const auto* scalar = std::get_if<Scalar>(&part.value)) {
    std::visit(AppendScalar{out}, *scalar);
  } else if (const auto* list = std::get_if<SampleNode::List>(&part.value)) {
    out += '[';
    for (const SampleNode& element : *list) {
      out += separator;
      append_json(out, element);
      separator = ", ";
    }
    out += ']';
  } else {
    out += '{';
    for (const auto& [name, member] : std::get<SampleNode::Struct>(part.value)) {
      out += separator;
      append_quoted(out, name);
      out += ": ";
      append_json(out, member);
      separator = ", ";
    }
    out += '}';
  }
}

void append_field(std::string& out, const FieldPath& field, const SampleNode& sample) {
  const SampleNode* part = field.find(sample);
  if (part == nullptr) {
    out += "null";
  } else if (field.is_length()) {
    out += std::to_string(std::get<SampleNode::List>(part->value).size());
  } else {
    append_json(out, *part);
  }
}

void append_fields(std::string& out, const std::vector<FieldPath>& fields,
                   const SampleNode& sample) {
  const char* separator = "";
  for (const FieldPath& field : fields) {
    out += separator;
    append_quoted(out, field.text());
    out += ": ";
    append_field(out, field, sample);
    separator = ", ";
  }
}

void append_plain(std::string& out, const Scalar& value) { std::visit(AppendPlain{out}, value); }

}  // namespace scarab::sample

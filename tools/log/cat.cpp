#include "tools/log/cat.hpp"

#include "common/config/json.hpp"
#include "common/sample/sample_json.hpp"
#include "common/sample/sample_text.hpp"
#include "tools/log/hex_text.hpp"

namespace scarab::log {
namespace {

class Printer {
 public:
  Printer(const Selection& selection, bool json, std::ostream& out)
      : selection_(selection), json_(json), out_(out) {}

  void print(const LogChannel& channel, const mcap::Message& message) {
    text_.clear();
    if (json_) {
      append_line(channel, message);
    } else {
      append_document(channel, message);
    }
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
  }

 private:
  void append_line(const LogChannel& channel, const mcap::Message& message) {
    text_ += "{\"topic\":";
    text_ += config::in_json_quotes(channel.topic);
    text_ += ",\"sequence\":" + std::to_string(message.sequence);
    text_ += ",\"log_time_ns\":\"" + std::to_string(message.log_time_ns);
    text_ += "\",\"publish_time_ns\":\"" + std::to_string(message.publish_time_ns) + "\",";
    const auto& fields = selection_.fields(channel);
    if (!channel.type) {
      text_ += "\"bytes\":";
      append_hex(text_, cdr_of(message));
    } else if (fields.empty()) {
      text_ += "\"value\":";
      append_json(text_, *channel.type, cdr_of(message));
    } else {
      text_ += "\"value\":{";
      append_fields(text_, fields, sample::sample_tree(*channel.type, cdr_of(message)));
      text_ += '}';
    }
    text_ += "}\n";
  }

  void append_document(const LogChannel& channel, const mcap::Message& message) {
    text_ += "---\ntopic: " + channel.topic;
    text_ += "\nsequence: " + std::to_string(message.sequence);
    text_ += "\nlog_time_ns: " + std::to_string(message.log_time_ns);
    text_ += "\npublish_time_ns: " + std::to_string(message.publish_time_ns) + "\n";
    const auto& fields = selection_.fields(channel);
    if (!channel.type) {
      text_ += "# " + channel.no_type + "\nbytes: ";
      append_hex(text_, cdr_of(message));
      text_ += '\n';
    } else if (fields.empty()) {
      text_ += "value:\n" + indented(sample::yaml_text(*channel.type, cdr_of(message)));
    } else {
      const sample::SampleNode sample = sample::sample_tree(*channel.type, cdr_of(message));
      text_ += "value:\n";
      for (const sample::FieldPath& field : fields) {
        text_ += "  " + field.text() + ": ";
        append_field(text_, field, sample);  // JSON is YAML's flow style
        text_ += '\n';
      }
    }
  }

  static std::string indented(const std::string& lines) {
    std::string text;
    for (std::size_t at = 0; at < lines.size();) {
      const std::size_t end = lines.find('\n', at) + 1;
      text += "  " + lines.substr(at, end - at);
      at = end;
    }
    return text;
  }

  const Selection& selection_;
  bool json_;
  std::ostream& out_;
  std::string text_;
};

}  // namespace

std::uint64_t print_messages(const Log& log, const Selection& selection, const CatOptions& options,
                             std::ostream& out) {
  std::uint64_t printed = 0;
  if (options.most == 0U || selection.topics().empty()) return printed;
  Printer printer(selection, options.json, out);
  log.for_each(
      [&](const LogChannel& channel, const mcap::Message& message) {
        read_message(channel, message, [&] {
          if (!selection.takes(channel, message)) return;
          printer.print(channel, message);
          ++printed;
        });
        return out.good() && printed != options.most;
      },
      selection.topics());
  return printed;
}

}  // namespace scarab::log

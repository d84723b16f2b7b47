#include "tools/log/csv.hpp"

#include <stdexcept>

#include "common/bus/sample_columns.hpp"
#include "services/logger/core/sample_header.hpp"
#include "tools/log/topic_type.hpp"

namespace scarab::log {
namespace {

std::string quoted(const std::string& value) {
  if (value.find_first_of(",\"\r\n") == std::string::npos) return value;
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

bool selects(const std::string& field, const std::string& column) {
  if (column.compare(0, field.size(), field) != 0) return false;
  return column.size() == field.size() || column[field.size()] == '.' ||
         column[field.size()] == '[';
}

/// Column numbers, in the order in which the fields were asked for.
std::vector<std::size_t> select(const std::vector<std::string>& columns,
                                const std::vector<std::string>& fields) {
  std::vector<std::size_t> selected;
  if (fields.empty()) {
    for (std::size_t i = 0; i < columns.size(); ++i) selected.push_back(i);
  }
  for (const std::string& field : fields) {
    const std::size_t before = selected.size();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (selects(field, columns[i])) selected.push_back(i);
    }
    if (selected.size() == before) {
      std::string known;
      for (const std::string& column : columns) known += " " + column;
      throw std::invalid_argument("no field " + field + "; there are" + known);
    }
  }
  return selected;
}

bus::TypeModel type_of(const mcap::Reader& reader, const std::string& topic) {
  if (find_channel(reader, topic) == nullptr) {
    std::string known;
    for (const auto& [id, channel] : reader.summary().channels) known += " " + channel.topic;
    throw std::invalid_argument("no topic " + topic + " in " + reader.path().string() +
                                (known.empty() ? "; it has none" : "; there are" + known));
  }
  auto type = find_type(reader, topic);
  if (!type) {
    throw std::invalid_argument(topic +
                                ": its type is none of Scarab's own; its IDL is in the log, "
                                "for any MCAP viewer that reads omgidl");
  }
  return *type;
}

void write_line(std::ostream& out, const std::vector<std::string>& front,
                const std::vector<std::string>& values, const std::vector<std::size_t>& columns) {
  const char* separator = "";
  for (const std::string& value : front) {
    out << separator << value;
    separator = ",";
  }
  for (const std::size_t column : columns) {
    out << separator << quoted(values[column]);
    separator = ",";
  }
  out << '\n';
}

}  // namespace

void write_csv(const mcap::Reader& reader, const CsvOptions& options, std::ostream& out) {
  const bus::TypeModel type = type_of(reader, options.topic);
  if (options.trial && !begins_with_header(type)) {
    throw std::invalid_argument(options.topic + ": its samples have no header, so no trial");
  }
  const bus::ColumnOptions column_options{options.sequence_elements};
  const auto names = bus::column_names(type, column_options);
  const auto columns = select(names, options.fields);
  using Front = std::vector<std::string>;
  write_line(out, options.times ? Front{"log_time_ns", "publish_time_ns"} : Front{}, names,
             columns);
  reader.for_each(
      [&](const mcap::Channel&, const mcap::Message& message) {
        const auto header = logger::read_sample_header(message.data.data(), message.data.size());
        if (options.trial && (!header || header->trial != *options.trial)) return;
        const auto* bytes = reinterpret_cast<const std::byte*>(message.data.data());
        const auto values = bus::column_values(type, {bytes, message.data.size()}, column_options);
        write_line(out,
                   options.times ? Front{std::to_string(message.log_time_ns),
                                         std::to_string(message.publish_time_ns)}
                                 : Front{},
                   values, columns);
      },
      {options.topic});
}

}  // namespace scarab::log

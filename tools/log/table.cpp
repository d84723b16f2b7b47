#include "tools/log/table.hpp"

#include <stdexcept>

#include "common/sample/sample_columns.hpp"
#include "common/sample/sample_json.hpp"
#include "tools/log/row.hpp"

namespace scarab::log {
namespace {

void append_cell(std::string& line, const std::string& value) {
  if (value.find_first_of(",\"\r\n") == std::string::npos) {
    line += value;
    return;
  }
  line += '"';
  for (const char c : value) {
    if (c == '"') line += '"';
    line += c;
  }
  line += '"';
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
      if (sample::has_column(field, columns[i])) selected.push_back(i);
    }
    if (selected.size() == before) {
      std::string known;
      for (const std::string& column : columns) known += " " + column;
      throw std::invalid_argument("no field " + field + "; there are" + known);
    }
  }
  return selected;
}

/// A line of the selected ones of `cells`, after `front`.
void append_line(std::string& line, const std::vector<std::string>& front,
                 const std::vector<std::string>& cells, const std::vector<std::size_t>& selected) {
  for (const std::string& value : front) line += value + ",";
  for (const std::size_t column : selected) {
    append_cell(line, cells[column]);
    line += ',';
  }
  if (line.empty()) {
    line = "\n";
  } else {
    line.back() = '\n';
  }
}

void write(std::ostream& out, const std::string& text) {
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

/// Calls f for each message; ends early when nobody reads what is written.
template <class F>
void for_each_taken(const Log& log, const Selection& selection, const TableOptions& options,
                    const std::ostream& out, F&& f) {
  log.for_each(
      [&](const LogChannel& channel, const mcap::Message& message) {
        read_message(channel, message, [&] {
          if (selection.takes(channel, message)) f(message);
        });
        return out.good();
      },
      {options.topic});
}

void append_object(std::string& line, const sample::TypeModel& type,
                   const std::vector<sample::FieldPath>& fields, bool times,
                   const mcap::Message& message) {
  const std::size_t begin = line.size();
  if (fields.empty()) {
    append_json(line, type, cdr_of(message));
  } else {
    line += '{';
    append_fields(line, fields, sample::sample_tree(type, cdr_of(message)));
    line += '}';
  }
  if (!times) return;
  line.insert(begin + 1, "\"log_time_ns\": \"" + std::to_string(message.log_time_ns) +
                             "\", \"publish_time_ns\": \"" +
                             std::to_string(message.publish_time_ns) + "\", ");
}

}  // namespace

void write_csv(const Log& log, const Selection& selection, const TableOptions& options,
               std::ostream& out) {
  const sample::TypeModel& type = require_type(log, options.topic);
  const sample::ColumnOptions column_options{options.sequence_elements};
  const auto names = sample::column_names(type, column_options);
  const auto selected = select(names, options.fields);
  Row row(type, column_options, selected);
  std::vector<std::string> front;
  if (options.times) front = {"log_time_ns", "publish_time_ns"};
  std::string line;
  append_line(line, front, names, selected);
  write(out, line);
  for_each_taken(log, selection, options, out, [&](const mcap::Message& message) {
    if (options.times) {
      front = {std::to_string(message.log_time_ns), std::to_string(message.publish_time_ns)};
    }
    line.clear();
    append_line(line, front, row.read(cdr_of(message)), selected);
    write(out, line);
  });
}

void write_json(const Log& log, const Selection& selection, const TableOptions& options,
                std::ostream& out) {
  const sample::TypeModel& type = require_type(log, options.topic);
  std::vector<sample::FieldPath> fields;
  for (const std::string& field : options.fields) fields.emplace_back(type, field);
  std::string line;
  const char* begin = "[\n";
  for_each_taken(log, selection, options, out, [&](const mcap::Message& message) {
    line = begin;
    begin = ",\n";
    append_object(line, type, fields, options.times, message);
    write(out, line);
  });
  out << (begin[0] == '[' ? "[]\n" : "\n]\n");
}

}  // namespace scarab::log

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/sample/cdr_builder.hpp"

namespace scarab::topic {

/// Reads one YAML or JSON document. Throws config::Error naming `source`, line, column and reason.
sample::WrittenValue read_value(const std::string& source, const std::string& text);

/// Takes a stream of documents apart: YAML documents, each ended by `---`, `...` or the end of the
/// stream, and JSON, each from its first bracket to the matching one.
class DocumentSplitter {
 public:
  /// A line without its end. Returns the document that it completes.
  std::optional<std::string> add(std::string_view line);
  /// The document that the end of the stream completes.
  std::optional<std::string> finish();

 private:
  std::optional<std::string> complete();
  void follow_brackets(std::string_view line);

  std::string document_;
  bool is_json_ = false;
  int open_ = 0;          ///< brackets of a JSON document
  bool in_text_ = false;  ///< between its double quotes
  bool escaped_ = false;  ///< behind a backslash there
};

}  // namespace scarab::topic

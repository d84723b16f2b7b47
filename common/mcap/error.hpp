#pragma once

#include <stdexcept>

/// MCAP files: errors are exceptions, all of them derived from mcap::Error; what() names the file
/// and the place.
namespace scarab::mcap {

class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The bytes are not what the specification says: no MCAP file, a wrong CRC, a length that leads
/// out of the record.
class FormatError : public Error {
  using Error::Error;
};

/// The operating system refused to open, read, write or rename; names the file and the reason (disk
/// full, ...).
class FileError : public Error {
  using Error::Error;
};

}  // namespace scarab::mcap

#pragma once

#include "proofs/map/parameter_map.hpp"

#include <filesystem>
#include <mutex>

namespace limes {

/// An append-only file of JSON lines that keeps the records of a map: the first line says of which map, every further one is a
/// record. A record is on the disk before it counts, so that a process may be killed at any time: a line without its end is
/// cut off on opening. Certificates of earlier runs are checked again when they are read.
class MapJournal {
 public:
  /// Opens or makes the file. \throws InputError when it cannot be read or written, belongs to another scheme, claim or tolerance, or holds
  /// a line that is no record of this map
  MapJournal(const std::filesystem::path& file, const Scheme& scheme, int smoothness, const Box& region, const MapOptions& options);

  /// How many records an earlier run left.
  std::size_t size() const { return records_.size(); }
  const MapRecord* find(const Box& cell) const;
  /// Appends the record and waits until the disk has it. Thread-safe.
  void append(const MapRecord& record);

 private:
  void read(const std::string& text);
  void write(const std::string& line);
  [[noreturn]] void fail() const;

  std::filesystem::path file_;
  VariableNames parameters_;
  std::string head_;
  int smoothness_;
  std::map<std::string, MapRecord> records_;
  std::mutex mutex_;
  /// Closed, and so unlocked, also when the constructor throws.
  struct Descriptor {
    Descriptor() = default;
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number = -1;
  };
  Descriptor descriptor_;
};

}  // namespace limes

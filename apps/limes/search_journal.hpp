#pragma once

#include "apps/limes/options.hpp"
#include "proofs/scheme_search.hpp"
#include "schemes/scheme.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace limes::app {

/// A finished start of a search: what the journal keeps of a SearchTrial.
struct SearchRecord {
  int start = 0;
  double approx_radius = 0;
  std::vector<Rational> parameters;
  /// "certified", "refuted", "undecided", or "screened": the screen said no.
  std::string verdict;
  std::string reason;
  /// The certificate's file; empty without one.
  std::string certificate;
};

/// The append-only file of a search, one JSON object a line: first what is searched (rule, claim, box, seed), then a record for
/// every finished start, written and flushed as a whole. An unfinished last line, from a program that was killed, is cut off.
class SearchJournal {
 public:
  /// Opens or creates it. An empty name: nothing is kept. \throws InputError "file:line: reason" when it is no journal or that of
  /// another search
  SearchJournal(const std::filesystem::path& file, const Scheme& scheme, const std::string& claim, const Box& box, unsigned seed);

  /// By start.
  const std::map<int, SearchRecord>& records() const { return records_; }
  /// \throws InputError when it cannot be written.
  void add(SearchRecord record);

 private:
  void append(const std::string& line);

  std::filesystem::path file_;
  std::map<int, SearchRecord> records_;
};

/// The output of `limes search --json`.
std::string search_json(const Scheme& scheme, const std::string& claim, const std::map<int, SearchRecord>& records,
                        const SearchRecord* best, const std::string& output);

}  // namespace limes::app

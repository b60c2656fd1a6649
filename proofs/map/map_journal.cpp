#include "proofs/map/map_journal.hpp"

#include "algebra/error.hpp"
#include "proofs/certificate.hpp"
#include "proofs/certificate_text_impl.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/number_json_impl.hpp"
#include "schemes/nonuniform/normalized_rule.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

Box region_from_json(const Json& json, const VariableNames& names) {
  Box region;
  for (const std::string& name : names) region.push_back(read_interval(json.at(name).get<std::string>()));
  return region;
}

Json record_to_json(const MapRecord& record, const VariableNames& names) {
  Json pieces = Json::array();
  for (const MapCell& piece : record.pieces) {
    Json json{{"region", region_to_json(piece.region, names)}, {"verdict", to_string(piece.verdict)}};
    if (!piece.certificate.empty()) json["certificate"] = Json::parse(piece.certificate);
    pieces.push_back(std::move(json));
  }
  return {{"cell", region_to_json(record.cell, names)}, {"failed", record.failed}, {"pieces", pieces}};
}

/// What the certificates of the map have in common with its head: the scheme.
Json definition_of(const Scheme& scheme, int smoothness, const Box& region) {
  Certificate certificate{.scheme = scheme.name,
                          .parameters = scheme.parameter_names(),
                          .definition = scheme.mask,
                          .claim = {.smoothness = smoothness, .negated = false, .space = {}, .region = region,
                                    .expected = Outcome::certified, .source = {}, .erratum = {}},
                          .verdict = Outcome::certified,
                          .theorem = Theorem::u1,
                          .proof = LeafProof{}};
  if (scheme.insertion_rule) certificate.definition = normalized_text(*scheme.insertion_rule);
  return Json::parse(to_json(certificate)).at("scheme");
}

MapCell piece_from_json(const Json& json, const VariableNames& names, const Json& definition, int smoothness) {
  MapCell piece{region_from_json(json.at("region"), names), Outcome::undecided, {}};
  const std::string verdict = json.at("verdict");
  if (verdict == "undecided") return piece;
  piece.verdict = verdict == "refuted" ? Outcome::refuted : Outcome::certified;
  const Json& certificate = json.at("certificate");
  const Json claim{{"statement", statement({.smoothness = smoothness, .negated = piece.verdict == Outcome::refuted, .space = {}, .region = {},
                                            .expected = Outcome::certified, .source = {}, .erratum = {}})},
                   {"region", region_to_json(piece.region, names)}};
  if (to_string(piece.verdict) != verdict || certificate.at("scheme") != definition || certificate.at("claim") != claim ||
      certificate.at("verdict") != "certified") {
    throw InputError("the certificate proves something else");
  }
  piece.certificate = certificate_text(certificate);
  if (const checker::Result result = checker::check(piece.certificate); !result.valid) {
    throw InputError(fmt::format("the certificate is invalid: {}: {}", result.step, result.reason));
  }
  return piece;
}

/// Whether the pieces lie in the cell and have its measure together.
bool is_partition(const MapRecord& record) {
  Rational sum = 0;
  for (const MapCell& piece : record.pieces) {
    if (!contains(record.cell, piece.region)) return false;
    sum += measure(piece.region);
  }
  return sum == measure(record.cell);
}

std::string key_of(const Box& cell) {
  std::string key;
  for (const Interval& interval : cell) key += to_string(interval) + ";";
  return key;
}

}  // namespace

MapJournal::MapJournal(const std::filesystem::path& file, const Scheme& scheme, int smoothness, const Box& region,
                       const MapOptions& options)
    : file_(file), parameters_(scheme.parameter_names()), smoothness_(smoothness) {
  head_ = Json{{"journal", "limes-map"},
               {"version", 1},
               {"scheme", definition_of(scheme, smoothness, region)},
               {"smoothness", smoothness},
               {"region", region_to_json(region, parameters_)},
               {"tolerance", to_string(options.tolerance)}}.dump() + "\n";
  descriptor_.number = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_.number < 0) fail();
  if (::flock(descriptor_.number, LOCK_EX | LOCK_NB) != 0) throw InputError(fmt::format("the journal '{}' is in use", file.string()));
  std::string text;
  {
    std::ifstream stream(file, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(stream), {});
    if (!stream) throw InputError(fmt::format("cannot read the journal '{}'", file.string()));
  }
  text.resize(text.rfind('\n') + 1);  // npos + 1 is 0
  if (!text.empty()) read(text);
  if (::ftruncate(descriptor_.number, static_cast<off_t>(text.size())) != 0) fail();
  if (text.empty()) write(head_);
}

MapJournal::Descriptor::~Descriptor() {
  if (number >= 0) ::close(number);
}

void MapJournal::read(const std::string& text) {
  std::size_t begin = text.find('\n') + 1;
  if (text.substr(0, begin) != head_) {
    throw InputError("it is the journal of another map (scheme, claim, region or tolerance); give it another name or remove it",
                     {file_.string(), 1, 0});
  }
  const Json definition = Json::parse(head_).at("scheme");
  for (int line = 2; begin < text.size(); ++line) {
    const std::size_t end = text.find('\n', begin);
    try {
      const Json json = Json::parse(text.substr(begin, end - begin));
      MapRecord record{region_from_json(json.at("cell"), parameters_), {}, json.at("failed").get<bool>()};
      for (const Json& piece : json.at("pieces")) record.pieces.push_back(piece_from_json(piece, parameters_, definition, smoothness_));
      if (!is_partition(record)) throw InputError("the pieces do not make up the cell");
      records_.insert_or_assign(key_of(record.cell), std::move(record));
    } catch (const Json::exception&) {
      throw InputError("no record of this map", {file_.string(), line, 0});
    } catch (const InputError& error) {
      throw InputError(error.reason(), {file_.string(), line, 0});
    }
    begin = end + 1;
  }
}

const MapRecord* MapJournal::find(const Box& cell) const {
  const auto place = records_.find(key_of(cell));
  return place == records_.end() ? nullptr : &place->second;
}

void MapJournal::append(const MapRecord& record) {
  const std::string line = record_to_json(record, parameters_).dump() + "\n";
  const std::scoped_lock lock(mutex_);
  write(line);
}

void MapJournal::write(const std::string& line) {
  // What a kill leaves of a line has no end, and is cut off when the file is opened again.
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t count = ::write(descriptor_.number, line.data() + done, line.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    done += static_cast<std::size_t>(count);
  }
  if (::fsync(descriptor_.number) != 0) fail();
}

void MapJournal::fail() const {
  throw InputError(fmt::format("cannot write the journal '{}': {}", file_.string(), std::strerror(errno)));
}

}  // namespace limes

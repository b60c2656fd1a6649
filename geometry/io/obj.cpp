#include "geometry/io/obj.hpp"

#include "algebra/error.hpp"
#include "algebra/text_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

namespace limes {
namespace {

/// The words of one line.
class Words {
 public:
  Words(std::string_view line, SourcePosition position) : rest_(line), position_(std::move(position)) {}

  std::string_view next() {
    const std::size_t begin = std::min(rest_.find_first_not_of(" \t\r"), rest_.size());
    const std::size_t end = std::min(rest_.find_first_of(" \t\r", begin), rest_.size());
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }
  [[noreturn]] void fail(const std::string& reason) const { throw InputError(reason, position_); }

  double coordinate() {
    const std::string_view word = next();
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      fail(word.empty() ? "a vertex needs three coordinates" : fmt::format("'{}' is no coordinate", word.substr(0, 40)));
    return value;
  }
  /// The vertex that a word like 7, 7/1/2 or -1 means. \pre the word is not empty
  MeshIndex vertex(std::string_view word, std::size_t count) const {
    const std::string_view number = word.substr(0, word.find('/'));
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || end != number.data() + number.size() || value == 0)
      fail(fmt::format("'{}' is no vertex", word.substr(0, 40)));
    if (value < 0) value += std::int64_t(count) + 1;
    if (value < 1 || value > std::int64_t(count)) fail(fmt::format("vertex {} is not defined before", number));
    return MeshIndex(value - 1);
  }

 private:
  std::string_view rest_;
  SourcePosition position_;
};

}  // namespace

PolygonMesh read_obj(std::string_view text, const std::filesystem::path& file) {
  PolygonMesh mesh;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    Words words(line.substr(0, line.find('#')), {file.string(), ++number, 0});
    const std::string_view kind = words.next();
    if (kind == "v") {
      const double x = words.coordinate(), y = words.coordinate();
      mesh.points.push_back({x, y, words.coordinate()});
    } else if (kind == "f" || kind == "l") {
      std::vector<MeshIndex> corners;
      for (std::string_view word = words.next(); !word.empty(); word = words.next())
        corners.push_back(words.vertex(word, mesh.points.size()));
      if (corners.size() < (kind == "f" ? 3u : 2u)) words.fail(kind == "f" ? "a face needs three vertices" : "a line needs two vertices");
      for (std::size_t i = 0; kind == "l" && i + 1 < corners.size(); ++i) mesh.sharp.emplace_back(corners[i], corners[i + 1]);
      if (kind == "f") mesh.faces.push_back(std::move(corners));
    }
  }
  if (mesh.faces.empty()) throw InputError("the mesh has no face", {file.string(), 0, 0});
  return mesh;
}

PolygonMesh read_obj_file(const std::filesystem::path& file) {
  return read_obj(read_text_file(file, std::size_t{1} << 30), file);
}

std::string to_obj(const PolygonMesh& mesh) {
  fmt::memory_buffer out;
  const auto to = std::back_inserter(out);
  for (const Point3& p : mesh.points) fmt::format_to(to, "v {} {} {}\n", p.x, p.y, p.z);
  for (const auto& face : mesh.faces) {
    out.push_back('f');
    for (const MeshIndex v : face) fmt::format_to(to, " {}", v + 1);
    out.push_back('\n');
  }
  for (const auto& [a, b] : mesh.sharp) fmt::format_to(to, "l {} {}\n", a + 1, b + 1);
  return fmt::to_string(out);
}

std::string to_obj(const QuadMesh& mesh) { return to_obj(polygon_mesh(mesh)); }

}  // namespace limes

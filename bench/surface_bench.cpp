// Surfaces: refining a closed mesh to level 6 in one thread, and the spectra around a vertex for every valence.
#include "analysis/surface/spectrum_settings.hpp"
#include "geometry/refine_mesh.hpp"
#include "proofs/checker/checker.hpp"
#include "proofs/prove.hpp"
#include "schemes/catalogue.hpp"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

namespace limes {
namespace {

Scheme load(const std::string& name) { return Catalogue(LIMES_SOURCE_DIR "/schemes/catalogue").load(name); }

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

/// The surface of a cube of k x k squares a side: all vertices regular but its 8 corners of valence 3.
PolygonMesh cube(MeshIndex k) {
  PolygonMesh mesh;
  std::map<std::array<MeshIndex, 3>, MeshIndex> known;
  const auto vertex = [&](std::array<MeshIndex, 3> p) {
    const auto [place, is_new] = known.emplace(p, MeshIndex(mesh.points.size()));
    if (is_new) mesh.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const MeshIndex side : {MeshIndex{0}, k}) {
      for (MeshIndex i = 0; i < k; ++i) {
        for (MeshIndex j = 0; j < k; ++j) {
          const auto at = [&](MeshIndex x, MeshIndex y) {
            std::array<MeshIndex, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = x;
            p[(axis + 2) % 3] = y;
            return vertex(p);
          };
          std::vector<MeshIndex> face{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          if (side == 0) std::reverse(face.begin(), face.end());
          mesh.faces.push_back(std::move(face));
        }
      }
    }
  }
  return mesh;
}

/// Six levels of `unified`; items are vertices of the last mesh.
void refine_six_levels(benchmark::State& state) {
  const auto sides = static_cast<MeshIndex>(state.range(0));
  const QuadMesh control = quad_mesh(cube(sides));
  const EdgeAngle angle{AngleType::trigonometric, Rational(1) / 4};
  const LevelWeights weights = approx_level_weights(*load("unified").surface, {angle, angle}, 6);
  std::size_t vertices = 0;
  for (auto _ : state) {
    const QuadMesh result = refine_mesh(control, weights, {6});
    vertices = result.vertices();
    benchmark::DoNotOptimize(result.points().data());
  }
  // V - E + F = 2 with E = 2 F
  if (vertices != control.faces() * 4096 + 2) return state.SkipWithError("a wrong number of vertices");
  state.SetItemsProcessed(std::int64_t(state.iterations()) * std::int64_t(vertices));
  state.counters["vertices"] = double(vertices);
  state.counters["peak_MiB"] = peak_mib();
}

/// All eigenvalues of valence 3 to 50, characteristic polynomials included.
void spectra(benchmark::State& state, const char* name, const char* setting, int rings) {
  const Scheme scheme = load(name);
  const SpectrumSettings settings = spectrum_settings(scheme, setting ? std::vector<std::string>{setting} : std::vector<std::string>{});
  for (auto _ : state) {
    const VertexSpectrum spectrum(scheme.surface->rings, rings);
    for (int n = 3; n <= 50; ++n) {
      int count = 0;
      for (const VertexEigenvalue& e : spectrum.eigenvalues(n, settings.at_level(0))) count += e.multiplicity;
      if (count != spectrum.size(n)) return state.SkipWithError("eigenvalues are missing");
    }
  }
}

/// "C1" at all valences, or at one, with its re-check, or the re-check alone.
void smooth(benchmark::State& state, const char* name, const char* valences, bool check_only) {
  const Scheme scheme = load(name);
  Claim claim = read_statement("C1");
  claim.valences = read_valences(valences);
  for (std::size_t k = 0; k < scheme.parameters.size(); ++k) claim.region.push_back(Interval::point(0));
  const Verdict verdict = prove(scheme, claim);
  if (verdict.outcome != Outcome::certified) return state.SkipWithError("not certified");
  for (auto _ : state) {
    if (check_only) benchmark::DoNotOptimize(checker::check(verdict.certificate_json));
    else benchmark::DoNotOptimize(prove(scheme, claim));
  }
}

BENCHMARK(refine_six_levels)->Arg(4)->Arg(6)->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spectra, catmull_clark, "catmull-clark", nullptr, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spectra, doo_sabin, "doo-sabin", nullptr, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spectra, unified_limit, "unified", nullptr, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spectra, unified_limit_three_rings, "unified", nullptr, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spectra, unified_level_0, "unified", "theta=pi/3", 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smooth, unified_all, "unified", "[3, inf)", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smooth, unified_all_check, "unified", "[3, inf)", true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smooth, unified_5_check, "unified", "5", true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smooth, catmull_clark_all_check, "catmull-clark", "[3, inf)", true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace limes

BENCHMARK_MAIN();

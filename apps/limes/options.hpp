#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limes::app {

/// Exit status of the program (docs/command-line.md).
enum ExitStatus : int { all_as_expected = 0, against_expectation = 1, bad_input = 2, undecided_or_interrupted = 3 };

/// What every verb takes.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  int threads = 0;  // 0: as many as the machine has
  unsigned seed = 1;
  std::optional<double> budget;  // seconds
};

struct ListOptions : CommonOptions {};

struct ShowOptions : CommonOptions {
  std::string scheme;
  bool latex = false;
  std::optional<int> characteristic_map;  // the valence
  std::vector<std::filesystem::path> outputs;
};

struct VerifyOptions : CommonOptions {
  std::vector<std::string> schemes;
  std::optional<std::string> claim;
  std::vector<std::string> parameters;  // "w=1/96", "w=[0,1/4]"
  std::optional<std::string> valence;   // "5", "3..50", "[3, inf)"
  std::filesystem::path certificates = "certificates";
};

struct CheckOptions : CommonOptions {
  std::vector<std::filesystem::path> certificates;
};

struct NormOptions : CommonOptions {
  std::string scheme;
  int order = 0;
  int level = 1;
  std::vector<std::string> parameters;
};

struct MapVerbOptions : CommonOptions {
  std::string scheme;
  std::string claim;
  std::vector<std::string> parameters;
  std::string tolerance;  // empty: a thousandth of the region
  std::filesystem::path journal;  // empty: none
  std::filesystem::path certificates = "certificates";
  std::vector<std::filesystem::path> outputs;
};

struct MatrixOptions : CommonOptions {
  std::string scheme;
  std::vector<std::string> parameters;
  bool latex = false;
};

struct SpectrumOptions : CommonOptions {
  std::string scheme;
  std::string valence;
  std::string level;  // empty: 0
  int rings = 0;      // 0: the least number
  std::vector<std::string> parameters;
};

struct DominanceOptions : CommonOptions {
  std::vector<std::string> schemes;
  std::optional<std::string> claim;
  std::vector<std::string> parameters;
  int boxes = 256;
};

struct SearchOptions : CommonOptions {
  std::string scheme;
  std::string claim;
  std::vector<std::string> parameters;
  int starts = 16;
  std::filesystem::path journal;       // empty: none is kept
  std::filesystem::path certificates;  // empty: none are written
  std::filesystem::path output;        // empty: none
};

struct DeriveOptions : CommonOptions {
  std::string weight;  // a function's text or a weight file
  std::string domain;
  std::string shifts;
  std::vector<std::string> constraints;
  std::optional<std::string> method;
  std::optional<int> samples;
  std::optional<int> precision;
  std::optional<int> decimals;
  std::string rounding;
  std::string optimise;
  std::string accuracy = "1/100";
  std::optional<int> cost;
  std::filesystem::path output;
  std::string name;
};

struct HolderOptions : CommonOptions {
  std::string scheme;
  std::vector<std::string> parameters;
  int digits = 6;
  std::filesystem::path certificates = "certificates";
};

struct JsrOptions : CommonOptions {
  std::filesystem::path file;
  int digits = 6;
  std::filesystem::path certificates = "certificates";
};

struct RefineOptions : CommonOptions {
  std::string scheme;
  std::filesystem::path data;
  int levels = 6;
  std::vector<std::filesystem::path> outputs;
  std::vector<std::string> parameters;
  std::string knots;  // a spacing or a file; empty: the scheme's default
  bool closed = false;
  std::string ends;  // "extend", "shrink"; empty: the scheme's default
  std::optional<double> comb;
  // Of surfaces:
  std::string net;  // "8x14"; empty: the data are a mesh
  std::string rows = "open", columns = "open";
  std::optional<double> azimuth, elevation;
  bool show_net = false;
};

struct TablesOptions : CommonOptions {
  std::vector<std::string> tables;  // names, files or directories; empty: all that come with Limes
};

struct FilterOptions : CommonOptions {
  std::string scheme;
  std::vector<std::string> parameters;
  std::optional<int> extension;
  std::string threshold;
  std::optional<int> shift;
  std::string precision = "exact";  // "double", a number of digits
  std::filesystem::path output;
  std::filesystem::path certificates = "certificates";
  std::filesystem::path plot;
  std::vector<std::string> beside;
};

/// How data of points, heights or pixels are read and continued at their ends.
struct GridOptions : CommonOptions {
  std::filesystem::path data, filters, output;
  bool closed = false;
  std::string ends = "half";  // "whole"
  bool heights = false;
  bool homogeneous = false;
  std::filesystem::path coarse;
};

struct DecomposeOptions : GridOptions {
  int levels = 1;
};

struct ReconstructOptions : GridOptions {
  std::optional<int> levels;
  std::optional<int> drop;
  std::optional<double> threshold, keep;
  std::filesystem::path compare;
};

struct ReportOptions : CommonOptions {
  std::vector<std::string> schemes;
  std::optional<std::string> claim;
  std::vector<std::string> parameters;
  std::filesystem::path output;
  std::optional<int> multiresolution;  // the greatest extension
  bool fragment = false;
  bool no_pdf = false;
  std::string format = "latex";   // "latex", "markdown"
  std::string engine = "pdflatex";  // "pdflatex", "lualatex"
};

int run_list(const ListOptions& options);
int run_show(const ShowOptions& options);
int run_verify(const VerifyOptions& options);
int run_check(const CheckOptions& options);
int run_norm(const NormOptions& options);
int run_map(const MapVerbOptions& options);
int run_matrix(const MatrixOptions& options);
int run_spectrum(const SpectrumOptions& options);
int run_dominance(const DominanceOptions& options);
int run_search(const SearchOptions& options);
int run_derive(const DeriveOptions& options);
int run_holder(const HolderOptions& options);
int run_jsr(const JsrOptions& options);
int run_refine(const RefineOptions& options);
int run_tables(const TablesOptions& options);
int run_multiresolution(const FilterOptions& options);
int run_decompose(const DecomposeOptions& options);
int run_reconstruct(const ReconstructOptions& options);
int run_report(const ReportOptions& options);

}  // namespace limes::app

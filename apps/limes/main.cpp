// The command line: the only source that includes CLI11. Each verb lives in the file of its name.

#include "apps/limes/options.hpp"

#include "algebra/error.hpp"
#include "schemes/unity/weight_problem.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

namespace {

using namespace limes::app;

void add_common(CLI::App& verb, CommonOptions& options) {
  verb.add_flag("--json", options.json, "Print one JSON object and nothing else on standard output");
  verb.add_flag("--quiet", options.quiet, "Print no more than is asked for: failures only, or the bare result");
  verb.add_option("--threads", options.threads, "Number of threads (default: all cores)")->check(CLI::Range(1, 1024));
  verb.add_option("--seed", options.seed, "Seed of randomised searches; results do not depend on it unless a verb says so");
  verb.add_option("--budget", options.budget, "Stop after so many seconds, keeping what is finished (exit status 3)")
      ->type_name("SECONDS")
      ->check(CLI::Range(1e-3, 1e8));
}

/// --param, which may be repeated.
CLI::Option* add_settings(CLI::App& verb, std::vector<std::string>& settings, const std::string& help, const char* type = "NAME=VALUE") {
  return verb.add_option("--param", settings, help)->type_name(type)->expected(1, 64)->allow_extra_args(false);
}

void add_certificates(CLI::App& verb, std::filesystem::path& directory, const std::string& help) {
  verb.add_option("--certificates", directory, help)->type_name("DIR")->capture_default_str();
}

void add_grid_options(CLI::App& verb, GridOptions& options) {
  verb.add_option("--filters", options.filters, "Filters that limes multiresolution -o has written")->required()->type_name("FILE");
  verb.add_flag("--closed", options.closed, "The data are periodic: a closed polygon, a torus");
  verb.add_option("--ends", options.ends, "Ends of open data: half (mirrored between points, the default) or whole (about the end points)")
      ->check(CLI::IsMember({"half", "whole"}))->type_name("SYMMETRY");
  verb.add_flag("--heights", options.heights, "The CSV file is a grid of heights, not a polygon");
  verb.add_flag("--homogeneous", options.homogeneous, "Carry a weight beside the data and divide by it: for masks without sum rules");
}

int run(int argc, char** argv) {
  CLI::App app("Limes proves how smooth the limits of subdivision schemes are.");
  app.set_version_flag("--version", "limes " LIMES_VERSION);
  app.require_subcommand(1);
  app.footer("Exit status: 0 every verdict as expected, 1 a verdict against expectation or a check failed,\n"
             "2 bad usage or input, 3 undecided, interrupted or out of budget.");

  ListOptions list;
  CLI::App* list_verb = app.add_subcommand("list", "List the schemes of the catalogue");
  add_common(*list_verb, list);

  ShowOptions show;
  CLI::App* show_verb = app.add_subcommand("show", "Show a scheme: mask, symbol, sum rules, claims");
  show_verb->add_option("scheme", show.scheme, "Catalogue name or scheme file")->required()->type_name("SCHEME");
  show_verb->add_flag("--latex", show.latex, "Print the mask and the symbol's factorisation in LaTeX");
  show_verb->add_option("--characteristic-map", show.characteristic_map, "Draw the characteristic map of a surface scheme at this valence into the files of -o")
      ->type_name("N")
      ->check(CLI::Range(3, 1000));
  show_verb->add_option("-o,--output", show.outputs, "With --characteristic-map: .svg, .pgf or .png files")->type_name("FILE");
  add_common(*show_verb, show);

  VerifyOptions verify;
  CLI::App* verify_verb = app.add_subcommand("verify", "Prove or refute the claims of schemes (default: of the whole catalogue)");
  verify_verb->add_option("scheme", verify.schemes, "Catalogue names or scheme files")->type_name("SCHEME");
  verify_verb->add_option("--claim", verify.claim, "Decide this claim, e.g. C2 or \"not C3\", instead of the file's own");
  add_settings(*verify_verb, verify.parameters, "Parameter value or interval: w=1/96, w=[1/1000,1/50], w=(0,1/8]");
  verify_verb->add_option("--valence", verify.valence, "Valences of a --claim about a surface scheme: N, N..M, \"[N, inf)\"; default: all")->type_name("RANGE");
  add_certificates(*verify_verb, verify.certificates, "Directory for the certificates");
  add_common(*verify_verb, verify);

  CheckOptions check;
  CLI::App* check_verb = app.add_subcommand("check", "Check certificates (the same as the program limes-check)");
  check_verb->add_option("certificate", check.certificates, "Certificate files")->required()->type_name("FILE");
  add_common(*check_verb, check);

  NormOptions norm;
  CLI::App* norm_verb = app.add_subcommand("norm", "Exact norm ||S_b^L|| of the difference scheme, a = sigma^{M+1} p^{-M} b");
  norm_verb->add_option("scheme", norm.scheme, "Catalogue name or scheme file")->required()->type_name("SCHEME");
  norm_verb->add_option("--order", norm.order, "M: b = p^M a / sigma^{M+1}")->required()->check(CLI::Range(-1, 64))->type_name("M");
  norm_verb->add_option("--level", norm.level, "L >= 1")->required()->check(CLI::Range(1, 40))->type_name("L");
  add_settings(*norm_verb, norm.parameters, "Parameter value: w=1/96");
  add_common(*norm_verb, norm);

  MapVerbOptions map;
  CLI::App* map_verb = app.add_subcommand("map", "Map a parameter region: where a scheme is C^m, where not, proved cell by cell");
  map_verb->add_option("scheme", map.scheme, "Catalogue name or scheme file")->required()->type_name("SCHEME");
  map_verb->add_option("--claim", map.claim, "C<m>, e.g. C2")->required();
  add_settings(*map_verb, map.parameters, "Interval or value: w=[0,1/10]; one or two parameters vary");
  map_verb->add_option("--tolerance", map.tolerance, "Measure that may stay unknown (default: a thousandth of the region)")->type_name("T");
  map_verb->add_option("--journal", map.journal, "File that keeps what is found: run again to continue after an interruption")
      ->type_name("FILE");
  add_certificates(*map_verb, map.certificates, "Directory for the certificates");
  map_verb->add_option("-o,--output", map.outputs, "Picture to write, by its ending: .svg, .pgf or .png; may be repeated")
      ->type_name("OUT")->expected(1, 64)->allow_extra_args(false);
  add_common(*map_verb, map);

  MatrixOptions matrix;
  CLI::App* matrix_verb = app.add_subcommand("matrix", "Subdivision matrix at an isolated knot ratio and its characteristic polynomial");
  matrix_verb->add_option("scheme", matrix.scheme, "Catalogue name or scheme file")->required()->type_name("SCHEME");
  add_settings(*matrix_verb, matrix.parameters, "Parameter value: w=1/96");
  matrix_verb->add_flag("--latex", matrix.latex, "Print matrix and factors in LaTeX");
  add_common(*matrix_verb, matrix);

  SpectrumOptions spectrum;
  CLI::App* spectrum_verb = app.add_subcommand("spectrum", "Eigenvalues of a surface scheme around a vertex or face of any valence, enclosed");
  spectrum_verb->add_option("scheme", spectrum.scheme, "Catalogue name or scheme file")->required()->type_name("SCHEME");
  spectrum_verb->add_option("--valence", spectrum.valence, "Valence N >= 3, or N..M")->required()->type_name("N");
  spectrum_verb->add_option("--level", spectrum.level, "Level K >= 0 (default: 0), K..L, or K.. for all from K on together")->type_name("K");
  spectrum_verb->add_option("--param", spectrum.parameters, "theta=pi/3, type=trigonometric|polynomial|hyperbolic, or mu=1 (default)")
      ->type_name("NAME=VALUE")->expected(1, 64)->allow_extra_args(false);
  spectrum_verb->add_option("--rings", spectrum.rings, "Rings of control points (default: the least number that works)")
      ->check(CLI::Range(1, 8))->type_name("R");
  add_common(*spectrum_verb, spectrum);

  DominanceOptions dominance;
  CLI::App* dominance_verb = app.add_subcommand("dominance", "Which tests prove that the eigenvalues at an isolated knot ratio are dominated");
  dominance_verb->add_option("scheme", dominance.schemes, "Catalogue names or scheme files (default: the non-uniform ones of the catalogue)")
      ->type_name("SCHEME");
  CLI::Option* dominance_claim = dominance_verb->add_option("--claim", dominance.claim, "C<m>, instead of the file's own claims");
  add_settings(*dominance_verb, dominance.parameters, "With --claim: parameter value or interval, w=[1/1000,1/50]")->needs(dominance_claim);
  dominance_verb->add_option("--boxes", dominance.boxes, "How many boxes one test may look at for one factor")
      ->check(CLI::Range(1, 1000000))->type_name("N")->capture_default_str();
  add_common(*dominance_verb, dominance);

  SearchOptions search;
  CLI::App* search_verb = app.add_subcommand("search", "Search parameter values that make a non-uniform scheme C^m, and prove them");
  search_verb->add_option("scheme", search.scheme, "Catalogue name or scheme file; its parameters are the unknowns")
      ->required()->type_name("SCHEME");
  search_verb->add_option("--claim", search.claim, "The smoothness wanted, e.g. C4")->required();
  add_settings(*search_verb, search.parameters, "Narrower interval of a parameter: w=[0,1/10]", "NAME=INTERVAL");
  search_verb->add_option("--starts", search.starts, "How many random starts")->check(CLI::Range(1, 1000000))->type_name("N")->capture_default_str();
  search_verb->add_option("--journal", search.journal, "File that keeps every finished start; the same search goes on from it")->type_name("FILE");
  search_verb->add_option("--certificates", search.certificates, "Directory for the certificates of what is found")->type_name("DIR");
  search_verb->add_option("-o,--output", search.output, "Scheme file to write with the best certified parameters")->type_name("FILE.toml");
  add_common(*search_verb, search);
  DeriveOptions derive;
  CLI::App* derive_verb = app.add_subcommand("derive", "Derive a mask from a weight function by least squares");
  derive_verb->add_option("--weight", derive.weight, "Weight function, e.g. 'cinpact(c=5, sigma=479/100)', or a weight file")->required()->type_name("WEIGHT");
  derive_verb->add_option("--domain", derive.domain, "Interval on which the refinement equation is asked for (default: the support)")->type_name("[A,B]");
  derive_verb->add_option("--shifts", derive.shifts, "Shifts s of the dilates w(2u - s) that take part")->type_name("FIRST..LAST");
  derive_verb->add_option("--constraint", derive.constraints, "sum-rules=K, interpolation or symmetry; may be repeated")
      ->type_name("CONSTRAINT")->expected(1, 64)->allow_extra_args(false);
  derive_verb->add_option("--method", derive.method, "samples (default), or integrals (exact for piecewise polynomials)")
      ->check(CLI::IsMember({"samples", "integrals"}))->type_name("METHOD");
  derive_verb->add_option("--samples", derive.samples, "Number of samples (default: 100000)")->check(CLI::Range(2, limes::max_samples))->type_name("N");
  derive_verb->add_option("--precision", derive.precision, "Bits of the arithmetic: 53 (double, the default), more: MPFR")
      ->check(CLI::Range(53, limes::max_precision))->type_name("BITS");
  derive_verb->add_option("--decimals", derive.decimals, "Decimals of the mask's free coefficients")->check(CLI::Range(1, 1000))->type_name("D");
  derive_verb->add_option("--round", derive.rounding, "Show the mask and E after rounding to float32 or to D significant digits")->type_name("float32|D");
  derive_verb->add_option("--optimise", derive.optimise, "Take the value of an argument that makes E least")->type_name("NAME=[A,B]");
  derive_verb->add_option("--accuracy", derive.accuracy, "Of --optimise: the value is a multiple of it")->type_name("T")->capture_default_str();
  derive_verb->add_option("--cost", derive.cost, "Table of E and certified smoothness for sum rules of order 0 .. K")->check(CLI::Range(0, 64))->type_name("K");
  derive_verb->add_option("-o,--output", derive.output, "Scheme file to write, with what is proved as its claims")->type_name("OUT.toml");
  derive_verb->add_option("--name", derive.name, "Name of the scheme written (default: that of the file)")->type_name("NAME");
  add_common(*derive_verb, derive);
  HolderOptions holder;
  CLI::App* holder_verb = app.add_subcommand("holder", "Certified enclosure of the Hoelder exponent");
  holder_verb->add_option("scheme", holder.scheme, "Catalogue name or scheme file")->required()->type_name("SCHEME");
  add_settings(*holder_verb, holder.parameters, "Parameter value: w=1/16");
  holder_verb->add_option("--digits", holder.digits, "Width of the enclosure: 10^-D")->check(CLI::Range(1, 30))->type_name("D")->capture_default_str();
  add_certificates(*holder_verb, holder.certificates, "Directory for the certificate");
  add_common(*holder_verb, holder);

  JsrOptions jsr;
  CLI::App* jsr_verb = app.add_subcommand("jsr", "Joint spectral radius of rational matrices: bounds with a certificate");
  jsr_verb->add_option("file", jsr.file, "Matrices: JSON, or CSV with a blank line between them")->required()->type_name("FILE");
  jsr_verb->add_option("--digits", jsr.digits, "Relative width of the bounds: 10^-D")->check(CLI::Range(1, 30))->type_name("D")->capture_default_str();
  add_certificates(*jsr_verb, jsr.certificates, "Directory for the certificate");
  add_common(*jsr_verb, jsr);

  RefineOptions refine;
  CLI::App* refine_verb = app.add_subcommand("refine", "Refine a polygon, a net or a mesh: points in, points or a picture out");
  refine_verb->add_option("scheme", refine.scheme, "Catalogue name or scheme file")->required()->type_name("SCHEME");
  refine_verb->add_option("data", refine.data, "Points, one a line: numbers separated by commas; of a surface scheme a mesh (.obj) or a net of points")->required()->type_name("DATA");
  refine_verb->add_option("--levels", refine.levels, "How often to refine")->check(CLI::Range(0, 60))->type_name("N")->capture_default_str();
  refine_verb->add_option("-o,--output", refine.outputs, "File to write, by its ending: .csv (of a surface: .obj), .svg, .pgf or .png; may be repeated")
      ->required()->type_name("OUT")->expected(1, 64)->allow_extra_args(false);
  add_settings(*refine_verb, refine.parameters, "Parameter value: w=1/16; of a nonstationary scheme theta=2*pi/7, type=hyperbolic");
  refine_verb->add_option("--knots", refine.knots,
                          "Of a non-uniform scheme: uniform, chordal, centripetal (default), or a file with one knot a line")
      ->type_name("SPACING|FILE");
  refine_verb->add_flag("--closed", refine.closed, "The polygon is closed: its first point follows its last");
  refine_verb->add_option("--ends", refine.ends, "Ends of an open polygon: extend it linearly (default of interpolatory schemes), shrink, or (nonstationary) exact")
      ->check(CLI::IsMember({"extend", "shrink", "exact"}))->type_name("RULE");
  refine_verb->add_option("--comb", refine.comb, "In pictures, a curvature comb with teeth of SCALE times the curvature")
      ->check(CLI::Range(-1e100, 1e100))->type_name("SCALE");
  refine_verb->add_option("--net", refine.net, "Of a surface scheme: the data are a net of points, row after row, in a .csv file")->type_name("ROWSxCOLUMNS");
  refine_verb->add_option("--rows", refine.rows, "Whether the last row of a net is its end, is followed by the first, or both are poles")
      ->check(CLI::IsMember({"open", "periodic", "poles", "first-pole"}))->type_name("ENDS");
  refine_verb->add_option("--columns", refine.columns, "The same for its columns")->check(CLI::IsMember({"open", "periodic"}))->type_name("ENDS");
  refine_verb->add_option("--azimuth", refine.azimuth, "In pictures of surfaces, the viewer's angle about the z axis, in degrees")
      ->check(CLI::Range(-360., 360.))->type_name("DEGREES");
  refine_verb->add_option("--elevation", refine.elevation, "The viewer's angle above the xy plane")->check(CLI::Range(-90., 90.))->type_name("DEGREES");
  refine_verb->add_flag("--show-net", refine.show_net, "In pictures of surfaces, draw the edges of the data too");
  add_common(*refine_verb, refine);

  TablesOptions tables;
  CLI::App* tables_verb = app.add_subcommand("tables", "Compute the tables of publications again and compare");
  tables_verb->add_option("table", tables.tables, "Names of tables, files or directories (default: all that come with Limes)")->type_name("TABLE");
  add_common(*tables_verb, tables);
  FilterOptions filters;
  CLI::App* filters_verb = app.add_subcommand("multiresolution", "Filters that reverse a scheme: banded, biorthogonal, of least orthogonality error");
  filters_verb->add_option("scheme", filters.scheme, "Catalogue name or scheme file")->required()->type_name("SCHEME");
  add_settings(*filters_verb, filters.parameters, "Parameter value: w=1/16");
  filters_verb->add_option("--extension", filters.extension, "Filters longer than the mask by up to L, an even number (default 0; with --threshold 64)")
      ->check(CLI::Range(0, 128))->type_name("L");
  filters_verb->add_option("--threshold", filters.threshold, "The least extension with an orthogonality error of at most E")->type_name("E");
  filters_verb->add_option("--shift", filters.shift, "Use this shift of A and B instead of the best one")->type_name("S");
  filters_verb->add_option("--precision", filters.precision, "exact (default), double, or a number of decimal digits")->type_name("KIND");
  filters_verb->add_option("-o,--output", filters.output, "File for the filters (JSON)")->type_name("FILE");
  add_certificates(*filters_verb, filters.certificates, "Directory for the certificate");
  filters_verb->add_option("--plot", filters.plot, "Orthogonality error against filter length: .svg, .pgf, .png or .csv")->type_name("FILE");
  filters_verb->add_option("--beside", filters.beside, "Another scheme for the plot; may be repeated")->type_name("SCHEME")->expected(1, 64)->allow_extra_args(false);
  add_common(*filters_verb, filters);

  DecomposeOptions decompose;
  CLI::App* decompose_verb = app.add_subcommand("decompose", "Split points, heights or an image into a coarse version and details");
  decompose_verb->add_option("data", decompose.data, "Points (CSV), a grid of heights (CSV with --heights), or an image (PNG)")->required()->type_name("DATA");
  add_grid_options(*decompose_verb, decompose);
  decompose_verb->add_option("--levels", decompose.levels, "How often")->check(CLI::Range(0, 30))->type_name("N")->capture_default_str();
  decompose_verb->add_option("-o,--output", decompose.output, "File for the pyramid")->required()->type_name("OUT");
  decompose_verb->add_option("--coarse", decompose.coarse, "File for the coarse version, .csv or .png")->type_name("FILE");
  add_common(*decompose_verb, decompose);

  ReconstructOptions reconstruct;
  CLI::App* reconstruct_verb = app.add_subcommand("reconstruct", "Put a pyramid together, or refine coarse data without details");
  reconstruct_verb->add_option("data", reconstruct.data, "A pyramid of limes decompose, or coarse data as for it")->required()->type_name("DATA");
  add_grid_options(*reconstruct_verb, reconstruct);
  reconstruct_verb->add_option("--levels", reconstruct.levels, "How many levels (default: all of a pyramid, 1 for coarse data)")->check(CLI::Range(0, 30))->type_name("N");
  reconstruct_verb->add_option("-o,--output", reconstruct.output, "File for the result, .csv or .png")->required()->type_name("OUT");
  reconstruct_verb->add_option("--coarse", reconstruct.coarse, "Use this coarse version in place of the pyramid's")->type_name("FILE");
  reconstruct_verb->add_option("--drop", reconstruct.drop, "Without the details of the N finest levels")->check(CLI::Range(0, 30))->type_name("N");
  reconstruct_verb->add_option("--threshold", reconstruct.threshold, "Without details of modulus below T")->check(CLI::Range(0.0, 1e300))->type_name("T");
  reconstruct_verb->add_option("--keep", reconstruct.keep, "With this fraction of the details only, those that change the data most")->check(CLI::Range(0.0, 1.0))->type_name("F");
  reconstruct_verb->add_option("--compare", reconstruct.compare, "Print how far the result is from this file")->type_name("FILE");
  add_common(*reconstruct_verb, reconstruct);

  ReportOptions report;
  CLI::App* report_verb = app.add_subcommand("report", "Write the proofs of schemes (default: of the whole catalogue) as LaTeX and PDF, or Markdown");
  report_verb->add_option("scheme", report.schemes, "Catalogue names or scheme files")->type_name("SCHEME");
  report_verb->add_option("-o,--output", report.output, "Directory of the report; with --fragment a .tex file")->required()->type_name("DIR|FILE");
  report_verb->add_option("--claim", report.claim, "Decide this claim instead of the file's own, e.g. C2 or \"not C3\"");
  add_settings(*report_verb, report.parameters, "Parameter value or interval: w=1/96, w=[1/1000,1/50], w=(0,1/8]");
  report_verb->add_option("--multiresolution", report.multiresolution, "Also the multiresolution filters of uniform binary schemes, with extensions up to L")
      ->check(CLI::Range(0, 128))->type_name("L");
  report_verb->add_flag("--fragment", report.fragment, "One file to \\input into an article, without preamble, packages and pictures");
  report_verb->add_flag("--no-pdf", report.no_pdf, "Do not run LaTeX");
  report_verb->add_option("--format", report.format, "latex or markdown")->check(CLI::IsMember({"latex", "markdown"}))->type_name("FORMAT")->capture_default_str();
  report_verb->add_option("--engine", report.engine, "pdflatex or lualatex")->check(CLI::IsMember({"pdflatex", "lualatex"}))->type_name("ENGINE")->capture_default_str();
  add_common(*report_verb, report);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    std::cerr << "limes: " << error.what() << " (see limes --help)\n";
    return bad_input;
  }
  if (list_verb->parsed()) return run_list(list);
  if (show_verb->parsed()) return run_show(show);
  if (verify_verb->parsed()) return run_verify(verify);
  if (check_verb->parsed()) return run_check(check);
  if (map_verb->parsed()) return run_map(map);
  if (matrix_verb->parsed()) return run_matrix(matrix);
  if (spectrum_verb->parsed()) return run_spectrum(spectrum);
  if (dominance_verb->parsed()) return run_dominance(dominance);
  if (search_verb->parsed()) return run_search(search);
  if (derive_verb->parsed()) return run_derive(derive);
  if (holder_verb->parsed()) return run_holder(holder);
  if (jsr_verb->parsed()) return run_jsr(jsr);
  if (refine_verb->parsed()) return run_refine(refine);
  if (tables_verb->parsed()) return run_tables(tables);
  if (filters_verb->parsed()) return run_multiresolution(filters);
  if (decompose_verb->parsed()) return run_decompose(decompose);
  if (reconstruct_verb->parsed()) return run_reconstruct(reconstruct);
  if (report_verb->parsed()) return run_report(report);
  return run_norm(norm);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int status = run(argc, argv);
    std::cout.flush();
    if (!std::cout) {
      std::cerr << "limes: cannot write to standard output\n";
      return bad_input;
    }
    return status;
  } catch (const limes::InternalError& error) {
    std::cerr << "limes: internal error, please report: " << error.what() << "\n";
    return against_expectation;
  } catch (const limes::Interrupted& error) {
    std::cerr << "limes: " << error.what() << "\n";
    return undecided_or_interrupted;
  } catch (const std::bad_alloc&) {
    std::cerr << "limes: out of memory\n";
    return undecided_or_interrupted;
  } catch (const std::exception& error) {
    std::cerr << "limes: " << error.what() << "\n";
    return bad_input;
  }
}

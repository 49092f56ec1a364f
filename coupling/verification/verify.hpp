#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// `presscheck verify`: the verification suite as a user sees it.
namespace coupling::verification {

/// One comparison of the engine with an answer known otherwise.
struct Benchmark {
  std::string name;   ///< "hertz/duration"
  double reference;   ///< the known answer
  double result;      ///< what the engine gives
  double error;       ///< |result - reference| / |reference|, or absolute where the reference is 0
  double tolerance;   ///< of `error`
  bool ok;            ///< error <= tolerance, false for NaN
  std::string source; ///< where the reference comes from
};

/// Fills in error and verdict.
Benchmark compare(std::string name, double reference, double result, double tolerance,
                  std::string source);

/// Every benchmark whose name contains `filter`; all of them if it is empty. A benchmark that
/// throws becomes a failed row whose source says why.
std::vector<Benchmark> run_benchmarks(std::string_view filter = {});

/// `verification.json`: a list of objects name, reference, result, error, tolerance, ok, source.
/// @throws dem::InvalidInput, WriteFailed if the file cannot be written
void write_json(std::vector<Benchmark> const& rows, std::filesystem::path const& file);

/// `verification.html`: one self-contained page. @throws dem::InvalidInput, WriteFailed
void write_html(std::vector<Benchmark> const& rows, std::filesystem::path const& file);

/// The table for a terminal.
std::string to_text(std::vector<Benchmark> const& rows);

struct VerifyOptions {
  std::string filter;
  std::filesystem::path folder = "."; ///< receives verification.json and verification.html
};

/// Runs, prints the table to standard output, writes both files.
/// @returns 0 if every row is within its tolerance, 1 otherwise
/// @throws dem::InvalidInput if no benchmark matches the filter or a file cannot be written
int run_verification(VerifyOptions const& options);

} // namespace coupling::verification

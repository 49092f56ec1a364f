#include "continuum/tool/help.hpp"

#include "continuum/ranks.hpp"
#include "continuum/tool/shared_factor.hpp"
#include "continuum/tool/shared_inverse.hpp"

#include <exception>
#include <map>
#include <memory>

namespace continuum {

namespace {
using ranks::Request;
using ranks::Task;
using Factors = std::map<int, std::unique_ptr<SharedFactor>>; // by the first rank's numbers

// Each task closes as the first rank's does: see CholeskyFactor, schur_complement, shared_inverse.
void take_part(Request const& request, Factors& factors) {
  switch (request.task) {
  case Task::factorise:
    ranks::together(
        [&] { factors[request.factor] = std::make_unique<SharedFactor>(no_rows(request.size)); });
    return;
  case Task::solve:
    ranks::together([&] { factors.at(request.factor)->solve({}); });
    return;
  case Task::condense:
    ranks::together([&] { shared_schur_complement(no_rows(request.size), {}); });
    return;
  case Task::invert:
    help_inverting(request.size);
    return;
  case Task::forget:
    factors.erase(request.factor);
    return;
  case Task::stop:
    return;
  }
}
} // namespace

void help_with_tools() {
  Factors factors;
  for (Request request = ranks::next(); request.task != Task::stop; request = ranks::next()) {
    try {
      take_part(request, factors);
    } catch (std::exception const&) {
      // The first rank throws the same, and has no factor either.
      if (request.task == Task::factorise)
        factors.erase(request.factor);
    }
  }
}

} // namespace continuum

#include "coupling/study/contour_lines.hpp"

#include "dem/expect.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

namespace coupling::study {
namespace {

/// An edge of the grid: from node (i, j) to the right or upwards.
struct Edge {
  int i, j;
  bool is_upward;

  bool operator==(Edge const&) const = default;
  bool operator<(Edge const& other) const {
    return std::tie(i, j, is_upward) < std::tie(other.i, other.j, other.is_upward);
  }
};

class Contour {
public:
  Contour(std::function<double(double, double)> const& f, GridAxis const& x, GridAxis const& y,
          double level)
      : f_(f), x_(x), y_(y), level_(level) {
    for (int j = 0; j < y.n; ++j)
      for (int i = 0; i < x.n; ++i)
        above_.push_back(f(x.at(i), y.at(j)) - level);
    for (int j = 0; j + 1 < y.n; ++j)
      for (int i = 0; i + 1 < x.n; ++i)
        cross(i, j);
  }

  std::vector<ContourLine> lines() {
    std::vector<ContourLine> all;
    for (bool const takes_closed : {false, true}) // open lines first, from their ends
      for (auto const& [edge, neighbours] : next_)
        if (!neighbours.empty() && (takes_closed || neighbours.size() == 1))
          all.push_back(walk(edge));
    return all;
  }

private:
  double at(int i, int j) const {
    return above_[static_cast<std::size_t>(j) * static_cast<std::size_t>(x_.n) +
                  static_cast<std::size_t>(i)];
  }
  bool is_in(int i, int j) const { return at(i, j) <= 0.0; }

  void join(Edge const& a, Edge const& b) {
    next_[a].push_back(b);
    next_[b].push_back(a);
  }

  /// The lines through the cell whose lower left node is (i, j).
  void cross(int i, int j) {
    Edge const bottom{i, j, false}, top{i, j + 1, false}, left{i, j, true}, right{i + 1, j, true};
    bool const a = is_in(i, j), b = is_in(i + 1, j), c = is_in(i + 1, j + 1), d = is_in(i, j + 1);
    std::vector<Edge> crossed;
    for (auto const& [edge, crosses] :
         {std::pair{bottom, a != b}, {right, b != c}, {top, c != d}, {left, d != a}})
      if (crosses)
        crossed.push_back(edge);
    if (crossed.size() == 2)
      join(crossed[0], crossed[1]);
    if (crossed.size() != 4)
      return;
    bool const middle =
        f_(0.5 * (x_.at(i) + x_.at(i + 1)), 0.5 * (y_.at(j) + y_.at(j + 1))) <= level_;
    // A middle like the lower left corner joins it with the upper right one.
    join(bottom, middle == a ? right : left);
    join(top, middle == a ? left : right);
  }

  std::array<double, 2> point_on(Edge const& edge) const {
    int const i = edge.i, j = edge.j, k = edge.is_upward ? i : i + 1,
              l = edge.is_upward ? j + 1 : j;
    auto const place = [&](double t) {
      return std::array{x_.at(i) + t * (x_.at(k) - x_.at(i)), y_.at(j) + t * (y_.at(l) - y_.at(j))};
    };
    double const from = at(i, j), to = at(k, l);
    if (from == 0.0 || to == 0.0 || !std::isfinite(from) || !std::isfinite(to))
      return place(to == 0.0 ? 1.0 : 0.0);
    std::uintmax_t n_tries = 60;
    auto const found = boost::math::tools::toms748_solve(
        [&](double t) {
          auto const p = place(t);
          return f_(p[0], p[1]) - level_;
        },
        0.0, 1.0, from, to, [](double a, double b) { return std::abs(b - a) < 1e-9; }, n_tries);
    return place(0.5 * (found.first + found.second));
  }

  ContourLine walk(Edge const& start) {
    ContourLine line{point_on(start)};
    Edge here = start;
    while (!next_[here].empty()) {
      Edge const there = next_[here].back();
      next_[here].pop_back();
      std::erase(next_[there], here);
      line.push_back(point_on(there));
      here = there;
    }
    return line;
  }

  std::function<double(double, double)> const& f_;
  GridAxis x_, y_;
  double level_;
  std::vector<double> above_;              // f - level at the nodes
  std::map<Edge, std::vector<Edge>> next_; // ordered: the lines do not hang on addresses
};

} // namespace

std::vector<ContourLine> contour_lines(std::function<double(double, double)> const& f,
                                       GridAxis const& x, GridAxis const& y, double level) {
  EXPECT(x.n >= 2 && y.n >= 2 && x.low < x.high && y.low < y.high);
  return Contour(f, x, y, level).lines();
}

} // namespace coupling::study

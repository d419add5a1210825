#include <algorithm>
#include <cmath>

#include "groundstation/sweep/sweep.hpp"

namespace skein {
namespace {

/// The value at the nearest rank: the least one that at least a share `p` of the values do not exceed.
double quantile(const std::vector<double>& sorted, double p) {
  const double rank = std::ceil(p * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

}  // namespace

nlohmann::ordered_json summary_of(std::vector<double> values) {
  std::ranges::sort(values);
  const double count = static_cast<double>(values.size());
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double sd = values.size() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  return {{"mean", mean},
          {"sd", sd},
          {"min", values.front()},
          {"p50", quantile(values, 0.5)},
          {"p95", quantile(values, 0.95)},
          {"max", values.back()}};
}

}  // namespace skein

// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/robuststatistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace trex {
namespace {

constexpr double kSigmaPerDeviation = 1.4826; // of the normal distribution
constexpr double kSigmasBetweenDeciles = 2.5631;
constexpr double kRefinedReach = 4.0; // in robust σ

double nth(std::vector<double>& values, std::size_t index)
{
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(index);
    std::ranges::nth_element(values, place);
    return *place;
}

double middle(std::vector<double>& values)
{
    if (values.empty()) {
        return 0.0;
    }
    const std::size_t half = values.size() / 2;
    const double upper = nth(values, half);
    return values.size() % 2 == 1 ? upper : (upper + nth(values, half - 1)) / 2.0;
}

double deviation(const std::vector<double>& values)
{
    std::vector<double> work = values;
    const double centre = middle(work);
    for (double& value : work) {
        value = std::abs(value - centre);
    }
    return kSigmaPerDeviation * middle(work);
}

} // namespace

double medianOf(std::span<const int> values)
{
    std::vector<double> work(values.begin(), values.end());
    return middle(work);
}

double middleOf(std::span<const double> values)
{
    std::vector<double> work(values.begin(), values.end());
    return middle(work);
}

double trimmedMeanOf(std::span<const int> values, double cut)
{
    std::vector<int> work(values.begin(), values.end());
    std::ranges::sort(work);
    const auto wanted = static_cast<std::size_t>(std::ceil(cut * double(work.size())));
    const std::size_t most = work.empty() ? 0 : (work.size() - 1) / 2;
    const std::size_t left = std::min(wanted, most);
    const auto kept = std::span(work).subspan(left, work.size() - 2 * left);
    return kept.empty()
        ? 0.0
        : std::accumulate(kept.begin(), kept.end(), 0.0) / static_cast<double>(kept.size());
}

double quantileOf(std::span<const int> values, double share)
{
    if (values.empty()) {
        return 0.0;
    }
    std::vector<double> work(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    return nth(work, static_cast<std::size_t>(std::lround(place)));
}

double deviationSigma(std::span<const int> values)
{
    return deviation({values.begin(), values.end()});
}

double robustSigma(std::span<const int> values)
{
    const double deciles = quantileOf(values, 0.9) - quantileOf(values, 0.1);
    return std::max(deviationSigma(values), deciles / kSigmasBetweenDeciles);
}

double refinedSigma(std::span<const int> values)
{
    const double centre = medianOf(values);
    const double reach = kRefinedReach * robustSigma(values);
    double squares = 0.0;
    int count = 0;
    for (const int value : values) {
        if (std::abs(value - centre) <= reach) {
            squares += (value - centre) * (value - centre);
            ++count;
        }
    }
    return count == 0 ? 0.0 : std::sqrt(squares / count);
}

double differenceSigma(std::span<const int> values)
{
    if (values.size() < 2) {
        return 0.0;
    }
    std::vector<double> differences;
    differences.reserve(values.size() - 1);
    for (std::size_t i = 1; i < values.size(); ++i) {
        differences.push_back(values[i] - values[i - 1]);
    }
    return deviation(differences) / std::numbers::sqrt2;
}

} // namespace trex

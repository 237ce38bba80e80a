// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/robuststatistics.h"

#include <algorithm>
#include <array>
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

std::optional<Parabola> fitParabola(std::span<const CurvePoint> points)
{
    if (points.size() < 4) {
        return std::nullopt;
    }
    // Sums of x^0 to x^4 and of y, xy, x²y; about the middle, where they are well conditioned.
    std::array<double, 5> s{};
    std::array<double, 3> t{};
    for (const auto& [x, y] : points) {
        double power = 1.0;
        for (std::size_t i = 0; i < s.size(); ++i, power *= x) {
            s.at(i) += power;
            if (i < t.size()) {
                t.at(i) += power * y;
            }
        }
    }
    const auto det = [](double a, double b, double c, double d, double e, double f, double g,
                        double h, double i) {
        return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
    };
    const double all = det(s[0], s[1], s[2], s[1], s[2], s[3], s[2], s[3], s[4]);
    if (all == 0.0) {
        return std::nullopt;
    }
    const double a = det(t[0], s[1], s[2], t[1], s[2], s[3], t[2], s[3], s[4]) / all;
    const double b = det(s[0], t[0], s[2], s[1], t[1], s[3], s[2], t[2], s[4]) / all;
    const double c = det(s[0], s[1], t[0], s[1], s[2], t[1], s[2], s[3], t[2]) / all;
    if (c == 0.0) {
        return std::nullopt;
    }
    double squares = 0.0;
    for (const auto& [x, y] : points) {
        const double off = y - (a + b * x + c * x * x);
        squares += off * off;
    }
    const double freedom = static_cast<double>(points.size() - 3);
    return Parabola{-b / (2.0 * c), a - b * b / (4.0 * c), c, std::sqrt(squares / freedom)};
}

} // namespace trex

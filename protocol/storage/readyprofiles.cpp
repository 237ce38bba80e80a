// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/readyprofiles.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

// clang-format off
constexpr auto kProfiles = std::to_array<ReadyProfileRow>({
    {"step-response", QT_TRANSLATE_NOOP("Bench", "Step response"),
     QT_TRANSLATE_NOOP("Bench", "Eight starts at once to speed 80, half of them in reverse. The decay of the starting current gives the mechanical time constant. Let the shafts turn freely.")},
    {"slow-ramp", QT_TRANSLATE_NOOP("Bench", "Slow ramp"),
     QT_TRANSLATE_NOOP("Bench", "One speed step a second up to 40, forward and then in reverse. The knee of the current shows where the shaft starts to turn: the dead zone and the friction at rest.")},
    {"current-speed", QT_TRANSLATE_NOOP("Bench", "Current against speed"),
     QT_TRANSLATE_NOOP("Bench", "Five speeds up to full speed, two seconds each, forward and in reverse. Shows what friction takes and what the motor draws at full speed under the load that it has now.")},
    {"left-right", QT_TRANSLATE_NOOP("Bench", "Left against right"),
     QT_TRANSLATE_NOOP("Bench", "Both motors at the same three speeds at the same time, forward and in reverse. Different currents mean different friction or load on the two sides.")},
    {"braking", QT_TRANSLATE_NOOP("Bench", "Braking"),
     QT_TRANSLATE_NOOP("Bench", "Runs at speed 100, pauses of several lengths with the brake and without, and starts again. The current of each new start tells how much of the speed was left.")},
    {"endurance", QT_TRANSLATE_NOOP("Bench", "Endurance"),
     QT_TRANSLATE_NOOP("Bench", "A quarter of an hour to and fro at speed 70. The drift of the running current shows warming, running in and wear; raise the number of rounds for a longer test.")},
});
// clang-format on

} // namespace

std::span<const ReadyProfileRow> readyProfiles()
{
    return kProfiles;
}

Result<BenchProfile> readyProfile(std::string_view key)
{
    const auto path =
        u":/profiles/"_s + QLatin1StringView(key.data(), qsizetype(key.size())) + u".json"_s;
    auto profile = loadBenchProfile(path);
    const auto row = std::ranges::find(kProfiles, key, &ReadyProfileRow::key);
    if (profile && row != kProfiles.end()) {
        profile->name = QCoreApplication::translate("Bench", row->title);
        profile->description = QCoreApplication::translate("Bench", row->description);
    }
    return profile;
}

} // namespace trex

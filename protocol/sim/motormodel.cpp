// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/motormodel.h"

#include <cmath>

namespace trex::sim {
namespace {

constexpr double kStep = 1e-3; // s
constexpr double kCoastDecay = 0.05; // the bridge's diodes end the current quickly
constexpr double kNoAmperes = 1e-6;

} // namespace

MotorModel::MotorModel(const MotorConstants& constants)
    : m_constants(constants), m_decay(std::exp(-kStep * constants.ohms / constants.henries))
{
}

void MotorModel::step(double duty, double brake)
{
    const MotorConstants& c = m_constants;
    const bool isCoasting = duty == 0.0 && brake == 0.0;
    if (isCoasting) {
        m_amperes = std::abs(m_amperes) < kNoAmperes ? 0.0 : m_amperes * kCoastDecay;
        if (m_amperes == 0.0 && m_speed == 0.0) {
            return;
        }
    } else {
        // The electrical side is exact over a step, in which the speed hardly changes.
        const double emf = c.voltSeconds * m_speed * (duty == 0.0 ? brake : 1.0);
        const double end = (duty * c.volts - emf) / c.ohms;
        m_amperes = end + (m_amperes - end) * m_decay;
    }
    if (m_isHeld) {
        m_speed = 0.0;
        return;
    }
    const double driving = c.voltSeconds * m_amperes - c.viscous * m_speed;
    const double free = m_speed + driving * kStep / c.inertia;
    // Dry friction and load can stop the shaft but never turn it.
    const double held = (c.coulomb + m_load * c.fullLoad) * kStep / c.inertia;
    m_speed = std::abs(free) <= held ? 0.0 : free - std::copysign(held, free);
}

} // namespace trex::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/procedure.h"

#include <utility>

namespace trex {

Procedure::Procedure(QObject* parent) : QObject(parent) { }

Procedure::~Procedure() = default;

void Procedure::setRunning()
{
    m_isRunning = true;
}

void Procedure::finish(const Result<void>& result)
{
    if (std::exchange(m_isRunning, false)) {
        emit finished(result);
    }
}

} // namespace trex

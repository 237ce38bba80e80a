// SPDX-License-Identifier: GPL-3.0-or-later
// What all fuzz targets share. A target is fuzz_NAME.cpp with the two functions below; clang links
// it with libFuzzer (./dev fuzz), every other build with standalone.cpp (./dev test).
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

/// Takes one input and returns 0; whatever does not hold ends the process.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace trex::fuzz {

/// A property that the target checks beyond "no crash".
inline void holds(bool condition, const char* what)
{
    if (!condition) {
        std::fprintf(stderr, "DOES NOT HOLD: %s\n", what);
        std::abort();
    }
}

/// The input as a stream of small choices. At its end everything is 0.
class Input {
public:
    Input(const std::uint8_t* data, std::size_t size)
        : m_rest(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size))
    {
    }
    [[nodiscard]] bool isAtEnd() const { return m_rest.isEmpty(); }
    [[nodiscard]] std::uint8_t byte()
    {
        if (m_rest.isEmpty()) {
            return 0;
        }
        const auto value = static_cast<std::uint8_t>(m_rest.front());
        m_rest = m_rest.sliced(1);
        return value;
    }
    [[nodiscard]] int word()
    {
        const int low = byte();
        return low | byte() << 8;
    }
    [[nodiscard]] int below(int count) { return byte() % count; }
    [[nodiscard]] bool flag() { return (byte() & 1) != 0; }
    /// At most so many bytes.
    [[nodiscard]] QByteArray bytes(qsizetype count)
    {
        const QByteArrayView taken = m_rest.first(count < m_rest.size() ? count : m_rest.size());
        m_rest = m_rest.sliced(taken.size());
        return taken.toByteArray();
    }
    [[nodiscard]] QByteArray rest() { return bytes(m_rest.size()); }

private:
    QByteArrayView m_rest;
};

} // namespace trex::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a call with a handler into something that a verb's coroutine can wait for.
#pragma once

#include "protocol/result.h"

#include <coroutine>
#include <functional>
#include <optional>
#include <utility>

namespace trex {

/// Begins an operation when waited for; its handler wakes the coroutine, on the main thread.
template <class T>
class Awaiting {
public:
    using Handler = std::function<void(Result<T>)>;
    using Begin = std::function<void(Handler)>;
    using EndedTest = std::function<bool()>;

    Awaiting(Begin begin, EndedTest hasEnded)
        : m_begin(std::move(begin)), m_hasEnded(std::move(hasEnded))
    {
    }
    [[nodiscard]] bool await_ready() const noexcept { return false; }

protected:
    /// `take` looks at the result and says whether the coroutine goes on. The handler may be
    /// called at once: the coroutine then never sleeps.
    template <class Take>
    bool suspend(std::coroutine_handle<> handle, Take take)
    {
        m_isBeginning = true;
        m_begin([this, handle, take](Result<T> result) {
            if (m_hasEnded() || m_result || !take(result)) {
                return;
            }
            m_result = std::move(result);
            if (!m_isBeginning) {
                handle.resume();
            }
        });
        m_isBeginning = false;
        return !m_result.has_value();
    }
    std::optional<Result<T>> m_result;

private:
    Begin m_begin;
    EndedTest m_hasEnded;
    bool m_isBeginning = false;
};

/// `co_await` gives the Result<T>.
template <class T>
class Attempt : public Awaiting<T> {
public:
    using Awaiting<T>::Awaiting;
    bool await_suspend(std::coroutine_handle<> handle)
    {
        return this->suspend(handle, [](const Result<T>&) { return true; });
    }
    Result<T> await_resume() { return std::move(*this->m_result); }
};

/// `co_await` gives the T; a failure is handed to `fail` and the coroutine sleeps for good.
template <class T>
class Required : public Awaiting<T> {
public:
    using Fail = std::function<void(const Error&)>;
    Required(typename Awaiting<T>::Begin begin, Fail fail, typename Awaiting<T>::EndedTest hasEnded)
        : Awaiting<T>(std::move(begin), std::move(hasEnded)), m_fail(std::move(fail))
    {
    }
    bool await_suspend(std::coroutine_handle<> handle)
    {
        return this->suspend(handle, [this](const Result<T>& result) {
            if (!result) {
                m_fail(result.error());
            }
            return result.has_value();
        });
    }
    T await_resume()
    {
        if constexpr (!std::is_void_v<T>) {
            return std::move(**this->m_result);
        }
    }

private:
    Fail m_fail;
};

} // namespace trex

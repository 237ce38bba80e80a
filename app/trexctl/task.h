// SPDX-License-Identifier: GPL-3.0-or-later
// A verb as a coroutine: it reads from top to bottom, and no event loop is nested.
#pragma once

#include <coroutine>
#include <exception>
#include <utility>

namespace trex {

/// Owns a verb's coroutine. It runs until its first wait when called; a verb that ends early is
/// simply never resumed and goes with its owner.
class Task {
public:
    struct promise_type { // NOLINT(readability-identifier-naming): the name is the language's
        Task get_return_object() { return Task(Handle::from_promise(*this)); }
        std::suspend_never initial_suspend() noexcept { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        void return_void() { }
        void unhandled_exception() { std::terminate(); }
    };
    using Handle = std::coroutine_handle<promise_type>;

    Task() = default;
    explicit Task(Handle handle) : m_handle(handle) { }
    Task(Task&& other) noexcept : m_handle(std::exchange(other.m_handle, {})) { }
    Task& operator=(Task&& other) noexcept
    {
        std::swap(m_handle, other.m_handle);
        return *this;
    }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;
    ~Task()
    {
        if (m_handle) {
            m_handle.destroy();
        }
    }

private:
    Handle m_handle;
};

} // namespace trex

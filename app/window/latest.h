// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace moldwright {

/// One place between two threads where only the newest value waits: what is put replaces what was not taken.
template <class Value>
class Latest {
public:
    void put(Value value) {
        const std::lock_guard lock(m_mutex);
        m_waiting = std::move(value);
    }

    /// None when it was taken already.
    [[nodiscard]] std::optional<Value> take() {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_waiting, std::nullopt);
    }

private:
    std::mutex m_mutex;
    std::optional<Value> m_waiting;
};

} // namespace moldwright

// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/binary_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>

namespace moldwright {

namespace {

static_assert(std::endian::native == std::endian::little, "project files are little-endian");

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
    bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

void appendCount(std::string& bytes, std::int64_t count) {
    append(bytes, &count, 1);
}

/// Reads a part from front to back; anything that does not fit makes it fail for good.
class PartReader {
public:
    explicit PartReader(const std::string& bytes) : m_bytes(bytes) {}

    std::int64_t count() {
        std::int64_t value = 0;
        read(&value, 1);
        return value;
    }
    template <class T>
    void read(T* values, std::int64_t number) {
        const auto left = static_cast<std::int64_t>((m_bytes.size() - m_at) / sizeof(T));
        m_ok = m_ok && number >= 0 && number <= left;
        if (!m_ok || number == 0)
            return;
        const std::size_t size = static_cast<std::size_t>(number) * sizeof(T);
        std::memcpy(values, m_bytes.data() + m_at, size);
        m_at += size;
    }
    /// Whether `number` values of `size` bytes each can follow: asked before memory is taken for them.
    bool canHold(std::int64_t number, std::size_t size) {
        m_ok = m_ok && number >= 0 && number <= static_cast<std::int64_t>((m_bytes.size() - m_at) / size);
        return m_ok;
    }
    [[nodiscard]] bool finished() const { return m_ok && m_at == m_bytes.size(); }

private:
    const std::string& m_bytes;
    std::size_t m_at = 0;
    bool m_ok = true;
};

} // namespace

std::string meshPart(const IndexedMesh& mesh) {
    std::string bytes;
    appendCount(bytes, mesh.V.rows());
    appendCount(bytes, mesh.F.rows());
    append(bytes, mesh.V.data(), static_cast<std::size_t>(mesh.V.size()));
    static_assert(sizeof(int) == 4);
    append(bytes, mesh.F.data(), static_cast<std::size_t>(mesh.F.size()));
    return bytes;
}

std::optional<IndexedMesh> readMeshPart(const std::string& bytes) {
    PartReader reader(bytes);
    const std::int64_t points = reader.count();
    const std::int64_t faces = reader.count();
    if (!reader.canHold(points, 3 * sizeof(double)) || !reader.canHold(faces, 3 * sizeof(int)))
        return std::nullopt;
    IndexedMesh mesh;
    mesh.V.resize(points, 3);
    mesh.F.resize(faces, 3);
    reader.read(mesh.V.data(), mesh.V.size());
    reader.read(mesh.F.data(), mesh.F.size());
    if (!reader.finished() || !mesh.V.allFinite())
        return std::nullopt;
    if (faces > 0 && (mesh.F.minCoeff() < 0 || mesh.F.maxCoeff() >= points))
        return std::nullopt;
    return mesh;
}

std::string labelsPart(const SideLabels& labels) {
    std::string bytes;
    appendCount(bytes, static_cast<std::int64_t>(labels.size()));
    append(bytes, labels.data(), labels.size());
    return bytes;
}

std::optional<SideLabels> readLabelsPart(const std::string& bytes) {
    PartReader reader(bytes);
    const std::int64_t count = reader.count();
    if (!reader.canHold(count, 1))
        return std::nullopt;
    SideLabels labels(static_cast<std::size_t>(count));
    reader.read(labels.data(), count);
    if (!reader.finished() || std::any_of(labels.begin(), labels.end(), [](auto label) { return label > 2; }))
        return std::nullopt;
    return labels;
}

std::string numbersPart(const std::vector<double>& numbers) {
    std::string bytes;
    appendCount(bytes, static_cast<std::int64_t>(numbers.size()));
    append(bytes, numbers.data(), numbers.size());
    return bytes;
}

std::optional<std::vector<double>> readNumbersPart(const std::string& bytes) {
    PartReader reader(bytes);
    const std::int64_t count = reader.count();
    if (!reader.canHold(count, sizeof(double)))
        return std::nullopt;
    std::vector<double> numbers(static_cast<std::size_t>(count));
    reader.read(numbers.data(), count);
    if (!reader.finished() ||
        !std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
        return std::nullopt;
    return numbers;
}

std::string indicesPart(const std::vector<int>& indices) {
    std::string bytes;
    appendCount(bytes, static_cast<std::int64_t>(indices.size()));
    append(bytes, indices.data(), indices.size());
    return bytes;
}

std::optional<std::vector<int>> readIndicesPart(const std::string& bytes, int end) {
    PartReader reader(bytes);
    const std::int64_t count = reader.count();
    if (!reader.canHold(count, sizeof(int)))
        return std::nullopt;
    std::vector<int> indices(static_cast<std::size_t>(count));
    reader.read(indices.data(), count);
    const bool ascend =
        std::adjacent_find(indices.begin(), indices.end(), std::greater_equal<>()) == indices.end();
    if (!reader.finished() || !ascend || (count > 0 && (indices.front() < 0 || indices.back() >= end)))
        return std::nullopt;
    return indices;
}

} // namespace moldwright

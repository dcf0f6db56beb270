// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_file.h"

#include "base/stop_point.h"
#include "mesh/measures.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstdint>

namespace moldwright {

namespace {

static_assert(std::endian::native == std::endian::little, "binary files are written in little-endian order");

template <class T>
void appendRaw(std::string& out, const T& value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// The shortest text that reads back as exactly this number.
template <class T>
void appendText(std::string& out, T value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    out.append(buffer.data(), end);
}

template <class Row>
void appendRow(std::string& out, const Row& row, auto offset) {
    for (Eigen::Index k = 0; k < row.size(); ++k) {
        out += ' ';
        appendText(out, row[k] + offset);
    }
    out += '\n';
}

Eigen::Vector3f unitNormal(const IndexedMesh& mesh, int f) {
    return doubleAreaVector(mesh, f).stableNormalized().cast<float>();
}

std::string stlBinary(const IndexedMesh& mesh) {
    std::string out = "Moldwright";
    out.resize(80, ' ');
    appendRaw(out, static_cast<std::uint32_t>(mesh.faceCount()));
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        const Eigen::Vector3f normal = unitNormal(mesh, f);
        out.append(reinterpret_cast<const char*>(normal.data()), 3 * sizeof(float));
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3f p = mesh.corner(f, k).cast<float>();
            out.append(reinterpret_cast<const char*>(p.data()), 3 * sizeof(float));
        }
        appendRaw(out, std::uint16_t{0});
    }
    return out;
}

std::string stlText(const IndexedMesh& mesh) {
    std::string out = "solid Moldwright\n";
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        out += "facet normal";
        appendRow(out, unitNormal(mesh, f), 0.0F);
        out += "outer loop\n";
        for (int k = 0; k < 3; ++k) {
            out += "vertex";
            appendRow(out, mesh.corner(f, k), 0.0);
        }
        out += "endloop\nendfacet\n";
    }
    return out + "endsolid Moldwright\n";
}

std::string obj(const IndexedMesh& mesh) {
    std::string out = "# Moldwright\n";
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        stopPointAt(v);
        out += 'v';
        appendRow(out, mesh.V.row(v), 0.0);
    }
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        out += 'f';
        appendRow(out, mesh.F.row(f), 1);
    }
    return out;
}

std::string off(const IndexedMesh& mesh) {
    std::string out =
        "OFF\n" + std::to_string(mesh.vertexCount()) + ' ' + std::to_string(mesh.faceCount()) + " 0\n";
    for (int v = 0; v < mesh.vertexCount(); ++v)
        appendRow(out, mesh.V.row(v), 0.0);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        out += '3';
        appendRow(out, mesh.F.row(f), 0);
    }
    return out;
}

/// `sides`: one per face, or none.
std::string ply(const IndexedMesh& mesh, const std::vector<std::uint8_t>& sides) {
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment Moldwright\nelement vertex " +
                      std::to_string(mesh.vertexCount()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(mesh.faceCount()) + "\nproperty list uchar int vertex_indices\n" +
                      (sides.empty() ? "" : "property uchar side\n") + "end_header\n";
    out.append(reinterpret_cast<const char*>(mesh.V.data()),
               static_cast<std::size_t>(mesh.V.size()) * sizeof(double));
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        out += '\3';
        out.append(reinterpret_cast<const char*>(mesh.F.row(f).data()), 3 * sizeof(int));
        if (!sides.empty())
            appendRaw(out, sides[static_cast<std::size_t>(f)]);
    }
    return out;
}

std::string bytesOf(const IndexedMesh& mesh, MeshFormat format) {
    switch (format) {
    case MeshFormat::StlBinary:
        return stlBinary(mesh);
    case MeshFormat::StlAscii:
        return stlText(mesh);
    case MeshFormat::Obj:
        return obj(mesh);
    case MeshFormat::Off:
        return off(mesh);
    case MeshFormat::Ply:
        break;
    }
    return ply(mesh, {});
}

} // namespace

std::optional<MeshFormat> formatFor(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".stl")
        return MeshFormat::StlBinary;
    if (ending == ".ply")
        return MeshFormat::Ply;
    if (ending == ".obj")
        return MeshFormat::Obj;
    if (ending == ".off")
        return MeshFormat::Off;
    return std::nullopt;
}

Result<void> writeMesh(const std::filesystem::path& file, const IndexedMesh& mesh, MeshFormat format) {
    return writeFileAtomically(file, bytesOf(mesh, format));
}

Result<void> writeSidedMesh(const std::filesystem::path& file, const IndexedMesh& mesh,
                            const std::vector<std::uint8_t>& sides) {
    return writeFileAtomically(file, ply(mesh, sides));
}

IndexedMesh roundToFloat(const IndexedMesh& mesh) {
    return {mesh.V.cast<float>().cast<double>(), mesh.F};
}

} // namespace moldwright

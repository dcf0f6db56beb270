// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/three_mf.h"

#include "base/stop_point.h"

// The flat C interface of lib3mf 1.8; the class interface of 2.x is not in Debian 12.
#include <lib3mf/Model/COM/NMR_DLLInterfaces.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace moldwright {

namespace {

using namespace NMR;

/// Owns what lib3mf hands out.
struct Release {
    void operator()(PLib3MFBase* instance) const { lib3mf_release(instance); }
};
using Handle = std::unique_ptr<PLib3MFBase, Release>;

void require(LIB3MFRESULT result, const char* step) {
    if (result != LIB3MF_OK)
        throw std::runtime_error(step);
}

/// A UUID that follows from what it stands for: those that lib3mf draws make two files of one mold differ.
class ContentId {
public:
    explicit ContentId(std::string_view bytes) { add(bytes); }

    void add(std::string_view bytes) {
        constexpr std::uint64_t prime = 0x100000001b3; // FNV-1a, once from each of two beginnings
        for (const unsigned char byte : bytes) {
            m_high = (m_high ^ byte) * prime;
            m_low = (m_low ^ (byte + 0x55U)) * prime;
        }
    }
    /// As RFC 9562 has it for ids of one's own making: version 8.
    [[nodiscard]] std::string text() const {
        std::array<char, 40> text{};
        const auto part = [](std::uint64_t from, int shift, std::uint64_t mask) {
            return static_cast<unsigned long long>((from >> shift) & mask);
        };
        std::snprintf(text.data(), text.size(), "%08llx-%04llx-8%03llx-9%03llx-%012llx",
                      part(m_high, 32, 0xffffffff), part(m_high, 16, 0xffff), part(m_high, 0, 0xfff),
                      part(m_low, 48, 0xfff), part(m_low, 0, 0xffffffffffff));
        return text.data();
    }

private:
    std::uint64_t m_high = 0xcbf29ce484222325;
    std::uint64_t m_low = 0x84222325cbf29ce4;
};

template <class T>
std::string_view bytesOf(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A mesh of the model, and what its content is known by.
struct AddedMesh {
    Handle object;
    ContentId id;
};

AddedMesh addMesh(PLib3MFModel* model, const PlateItem& item) {
    std::vector<MODELMESHVERTEX> points(static_cast<std::size_t>(item.mesh->vertexCount()));
    for (std::size_t v = 0; v < points.size(); ++v)
        for (int k = 0; k < 3; ++k)
            points[v].m_fPosition[k] = static_cast<float>(item.mesh->V(static_cast<Eigen::Index>(v), k));
    std::vector<MODELMESHTRIANGLE> faces(static_cast<std::size_t>(item.mesh->faceCount()));
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (int k = 0; k < 3; ++k)
            faces[f].m_nIndices[k] = static_cast<DWORD>(item.mesh->F(static_cast<Eigen::Index>(f), k));
    PLib3MFModelMeshObject* object = nullptr;
    require(lib3mf_model_addmeshobject(model, &object), "add a mesh");
    Handle handle(object);
    require(lib3mf_object_setnameutf8(object, item.name.c_str()), "name a mesh");
    require(lib3mf_meshobject_setgeometry(object, points.data(), static_cast<DWORD>(points.size()),
                                          faces.data(), static_cast<DWORD>(faces.size())),
            "fill a mesh");
    ContentId id(item.name);
    id.add(bytesOf(points));
    id.add(bytesOf(faces));
    require(lib3mf_object_setuuidutf8(object, id.text().c_str()), "identify a mesh");
    return {std::move(handle), id};
}

void placeOnPlate(PLib3MFModel* model, const AddedMesh& mesh, const Eigen::Isometry3d& placement) {
    MODELTRANSFORM transform{};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            transform.m_fFields[row][column] = static_cast<float>(placement.matrix()(row, column));
    PLib3MFModelBuildItem* item = nullptr;
    require(lib3mf_model_addbuilditem(model, mesh.object.get(), &transform, &item), "place a mesh");
    const Handle owner(item);
    ContentId id = mesh.id;
    id.add("placed");
    require(lib3mf_builditem_setuuidutf8(item, id.text().c_str()), "identify a place");
}

/// What lib3mf writes, as it goes; asked for the size first it would do all of it twice.
struct Bytes {
    std::string bytes;
    std::size_t at = 0;

    static std::uint32_t write(const BYTE* data, std::uint32_t count, void* self) {
        Bytes& into = *static_cast<Bytes*>(self);
        into.bytes.resize(std::max(into.bytes.size(), into.at + count));
        std::copy_n(reinterpret_cast<const char*>(data), count,
                    into.bytes.begin() + static_cast<std::ptrdiff_t>(into.at));
        into.at += count;
        return 0;
    }
    static std::uint32_t seek(std::uint64_t position, void* self) {
        static_cast<Bytes*>(self)->at = position;
        return 0;
    }
};

std::string written(PLib3MFModel* model) {
    PLib3MFModelWriter* writer = nullptr;
    require(lib3mf_model_querywriter(model, "3mf", &writer), "begin to write");
    const Handle owner(writer);
    Bytes into;
    require(lib3mf_writer_writetocallback(writer, reinterpret_cast<void*>(&Bytes::write),
                                          reinterpret_cast<void*>(&Bytes::seek), &into),
            "write");
    return std::move(into.bytes);
}

} // namespace

Result<std::string> threeMfBytes(const std::string& title, const std::vector<PlateItem>& items) try {
    PLib3MFModel* model = nullptr;
    require(lib3mf_createmodel(&model), "begin");
    const Handle owner(model);
    require(lib3mf_model_setunit(model, MODELUNIT_MILLIMETER), "set the unit");
    require(lib3mf_model_addmetadatautf8(model, "Title", title.c_str()), "set the title");
    ContentId all(title);
    for (const PlateItem& item : items) {
        stopPoint();
        const AddedMesh mesh = addMesh(model, item);
        placeOnPlate(model, mesh, item.placement);
        all.add(mesh.id.text());
    }
    require(lib3mf_model_setbuilduuidutf8(model, all.text().c_str()), "identify the plate");
    stopPoint(); // lib3mf itself cannot be stopped: where its file fails, its destructors end the program
    std::string bytes = written(model);
    stopPoint();
    return bytes;
} catch (const std::runtime_error& error) {
    return failure(ErrorCode::Internal,
                   MW_TEXT("Mold", "The 3MF file could not be made: lib3mf failed to {0}."), {error.what()});
}

} // namespace moldwright

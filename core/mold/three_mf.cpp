// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/three_mf.h"

#include "base/stop_point.h"

// The flat C interface of lib3mf 1.8; the class interface of 2.x is not in Debian 12.
#include <lib3mf/Model/COM/NMR_DLLInterfaces.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>

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

Handle addMesh(PLib3MFModel* model, const PlateItem& item) {
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
    return handle;
}

void placeOnPlate(PLib3MFModel* model, PLib3MFModelMeshObject* object, const Eigen::Isometry3d& placement) {
    MODELTRANSFORM transform{};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            transform.m_fFields[row][column] = static_cast<float>(placement.matrix()(row, column));
    PLib3MFModelBuildItem* item = nullptr;
    require(lib3mf_model_addbuilditem(model, object, &transform, &item), "place a mesh");
    lib3mf_release(item);
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
    for (const PlateItem& item : items) {
        stopPoint();
        const Handle object = addMesh(model, item);
        placeOnPlate(model, object.get(), item.placement);
    }
    stopPoint(); // lib3mf itself cannot be stopped: where its file fails, its destructors end the program
    std::string bytes = written(model);
    stopPoint();
    return bytes;
} catch (const std::runtime_error& error) {
    return failure(ErrorCode::Internal,
                   MW_TEXT("Mold", "The 3MF file could not be made: lib3mf failed to {0}."), {error.what()});
}

} // namespace moldwright

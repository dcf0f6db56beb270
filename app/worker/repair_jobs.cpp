// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/wire.h"
#include "repair/mend_surface.h"
#include "repair/wrap_surface.h"
#include "worker/jobs.h"

#include <exception>
#include <functional>
#include <optional>

namespace moldwright {

namespace {

/// A request's surface; none where it is no surface.
std::optional<IndexedMesh> meshIn(WireReader& reader) {
    IndexedMesh mesh;
    mesh.V = reader.matrix<Points>();
    mesh.F = reader.matrix<Triangles>();
    if (!reader.whole() || mesh.F.rows() == 0 || mesh.F.minCoeff() < 0 || mesh.F.maxCoeff() >= mesh.V.rows())
        return std::nullopt;
    return mesh;
}

/// What CGAL throws is an answer too.
Result<std::string> guarded(const std::function<std::string()>& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        return failure(ErrorCode::Worker, MW_TEXT("exchange", "CGAL gave up on this surface."));
    }
}

std::unexpected<Error> askedForNothing() {
    return failure(ErrorCode::Worker, MW_TEXT("exchange", "The worker program was asked for nothing."));
}

} // namespace

Result<std::string> mendJob(const std::string& request) {
    WireReader reader(request);
    const std::optional<IndexedMesh> mesh = meshIn(reader);
    if (!mesh)
        return askedForNothing();
    return guarded([&] {
        const MendedSurface mended = mendSurface(*mesh);
        WireWriter answer;
        answer.matrix(mended.mesh.V);
        answer.matrix(mended.mesh.F);
        for (const int count :
             {mended.facesRemoved, mended.holesFilled, mended.facesFilled, mended.crossings})
            answer.number(count);
        answer.matrix(Eigen::Matrix<double, 1, 1>(mended.largestHole));
        return answer.bytes();
    });
}

Result<std::string> wrapJob(const std::string& request) {
    WireReader reader(request);
    const std::optional<IndexedMesh> mesh = meshIn(reader);
    const auto lengths = reader.matrix<Eigen::Matrix<double, Eigen::Dynamic, 1>>();
    if (!mesh || !reader.whole() || lengths.size() != 2 || !(lengths.minCoeff() > 0))
        return askedForNothing();
    return guarded([&] {
        const IndexedMesh wrap = wrapSurface(*mesh, lengths[0], lengths[1]);
        WireWriter answer;
        answer.matrix(wrap.V);
        answer.matrix(wrap.F);
        return answer.bytes();
    });
}

} // namespace moldwright

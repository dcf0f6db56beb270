// SPDX-License-Identifier: AGPL-3.0-or-later
// Every entry of the defective set: loaded, mended with a word about it, or refused with a sentence. Never a
// crash, a hang, or wrong geometry without a word.
#include "exchange/mesh_file.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/folders.h"

#include <gtest/gtest.h>

#include <set>

using namespace moldwright;
namespace fs = std::filesystem;

namespace {

enum class Outcome { Loads, Mended, Refused };
using enum Outcome;

struct Expectation {
    const char* file;
    Outcome outcome;
    const char* words = ""; ///< the first repair, or part of the refusal
    double volume = 0;      ///< of what loads, to six digits
};

// clang-format off
const Expectation expectations[] = {
    {"UPPER.CASE.NAME.STL", Loads, "", 0.679729},
    {"ascii_bom.stl", Loads, "", 4.04704},
    {"ascii_crlf.ply", Loads, "", 4.04704},
    {"ascii_crlf_tabs.stl", Loads, "", 4.04704},
    {"ascii_leading_blank.stl", Loads, "", 4.04704},
    {"ascii_no_name.stl", Loads, "", 4.04704},
    {"ascii_two_solids.stl", Mended, "320 repeated faces were removed.", 4.04704},
    {"ascii_uppercase.stl", Loads, "", 4.04704},
    {"big_endian.ply", Loads, "", 0.679729},
    {"binary_colour_zero_normals.stl", Loads, "", 0.679729},
    {"binary_solid_facet_header.stl", Loads, "", 0.679729},
    {"binary_solid_header.stl", Loads, "", 0.679729},
    {"binary_wrong_normals.stl", Loads, "", 0.679729},
    {"bom_crlf.obj", Loads, "", 4.04704},
    {"coff_vertex_colours.off", Loads, "", 4.04704},
    {"comma_decimals.obj", Refused, "line 1: a point needs three finite numbers"},
    {"concave_ngon.obj", Loads, "", 5.25},
    {"count_4g.stl", Refused, "announces 4294967295 triangles but holds 1654"},
    {"count_too_low.stl", Refused, "announces 1554 triangles but holds 1654"},
    {"count_zero.stl", Refused, "announces 0 triangles but holds 1654"},
    {"counts_negative.off", Refused, "line 2: here should stand how many points and faces there are"},
    {"cube_12.stl", Loads, "", 1},
    {"cubes_sharing_a_face.stl", Mended, "4 repeated faces were removed.", 2},
    {"directory.stl", Refused, "is a folder"},
    {"double_big_endian.ply", Loads, "", 0.679729},
    {"double_triangle.obj", Refused, "encloses no volume"},
    {"dup_faces.obj", Mended, "50 repeated faces were removed.", 0.679729},
    {"dup_faces_flipped.ply", Mended, "50 repeated faces were removed.", 0.679729},
    {"dup_vertices_unmerged.obj", Mended, "4133 equal points were welded.", 0.679729},
    {"empty.obj", Refused, "is an empty file"},
    {"empty.off", Refused, "is an empty file"},
    {"empty.stl", Refused, "is an empty file"},
    {"extra_properties.ply", Loads, "", 4.04704},
    {"face_colours.off", Loads, "", 4.04704},
    {"faces_before_vertices.ply", Loads, "", 4.04704},
    {"fin_on_sphere.ply", Refused, "has a hole"},
    {"flat_pillow.obj", Refused, "encloses no volume"},
    {"flipped_all.obj", Mended, "The surface was inside out and was turned.", 0.679729},
    {"flipped_some.stl", Mended, "164 faces looked inward and were turned.", 0.679729},
    {"format_2_0.ply", Refused, "line 2: "},
    {"header_only.ply", Refused, "no triangles"},
    {"hole_large.ply", Refused, "has a hole"},
    {"hole_one_face.stl", Refused, "has a hole"},
    {"hopf_link.ply", Loads, "", 38.1393},
    {"hopf_link_touching.obj", Refused, "crosses itself in 290 places"},
    {"huge_1e30.ply", Loads, "", 6.79729e+89},
    {"index_negative.off", Refused, "line 484: a face uses point -1"},
    {"index_out_of_range.obj", Refused, "line 483: a face uses point 69999"},
    {"index_out_of_range.off", Refused, "line 484: a face uses point 99999"},
    {"index_out_of_range.ply", Refused, "face 1653: a face uses point 1000000000"},
    {"inf_binary.stl", Refused, "triangle 20: a coordinate is not a finite number"},
    {"klein_bottle.off", Refused, "only one side"},
    {"line_continuation.obj", Loads, "", 4.04704},
    {"mac_cr_line_ends.obj", Loads, "", 4.04704},
    {"moebius.stl", Refused, "has a hole"},
    {"nan_ascii.stl", Refused, "line 5: a point needs three finite numbers"},
    {"nan_inf.obj", Refused, "line 4: a point needs three finite numbers"},
    {"near_dup_vertices.obj", Mended, "4133 points within a millionth of the size of each other were welded.", 0.679729},
    {"needle_tiny_edge.ply", Loads, "", 4.1526},
    {"negative_indices.obj", Loads, "", 1},
    {"nested_cavity.obj", Refused, "inside another"},
    {"nested_same_orientation.ply", Refused, "inside another"},
    {"no_keyword.off", Loads, "", 4.04704},
    {"noff_normals.off", Loads, "", 4.04704},
    {"nonmanifold_edge.obj", Refused, "more than two faces meet"},
    {"off_named.ply", Loads, "", 4.04704},
    {"offset_1e5.stl", Loads, "", 0.6803},
    {"offset_1e9.obj", Refused, "shrink to a line"},
    {"offset_1e9_17digits.obj", Loads, "", 0.679729},
    {"order_zyx.ply", Loads, "", 4.04704},
    {"overflow_numbers.obj", Refused, "line 1: a point needs three finite numbers"},
    {"png_renamed.obj", Refused, "not an OBJ file"},
    {"quads.off", Loads, "", 1},
    {"quads_crlf_utf8.obj", Loads, "", 1},
    {"random_bytes.stl", Refused, "announces 2839906011 triangles but holds 98"},
    {"real_42400_degenerate.stl", Refused, "3 faces of real_42400_degenerate.stl have no area"},
    {"real_angle_block.STL", Mended, "46 points within a millionth of the size of each other were welded.", 1.14552},
    {"real_bun_zipper_res3.ply", Refused, "has 54 holes"},
    {"real_bunny_scan_holes.ply", Refused, "has 5 holes"},
    {"real_camelhead_open.off", Refused, "has a hole"},
    {"real_casting_inside_out.off", Mended, "The surface was inside out and was turned.", 0.0339123},
    {"real_comments.off", Loads, "", 12.3168},
    {"real_conrod.stl", Refused, "crosses itself in 13 places"},
    {"real_conveyor_degenerate.stl", Refused, "34 faces of real_conveyor_degenerate.stl have no area"},
    {"real_cow_nonmanifold.obj", Refused, "touches itself in a single point"},
    {"real_empty.stl", Refused, "no triangles"},
    {"real_footbones_26.ply", Refused, "crosses itself in 381 places"},
    {"real_hippo_tristrips.ply", Refused, "tristrips"},
    {"real_hourglass_normals_bad.stl", Loads, "", 3.4297e-05},
    {"real_hourglass_stray_facet.stl", Refused, "has a hole"},
    {"real_igl_cow_selfint.off", Refused, "more than two faces meet"},
    {"real_laurana_scan.ply", Refused, "has 4 holes"},
    {"real_lion_open.off", Refused, "has a hole"},
    {"real_many_small_holes.ply", Refused, "has 32 holes"},
    {"real_moebius.obj", Refused, "has a hole"},
    {"real_negative_indices.obj", Loads, "", 8},
    {"real_non_manif_hole.ply", Refused, "has 2 holes"},
    {"real_points_only.ply", Refused, "holds 5 points but no faces"},
    {"real_quad_index_out_of_range.obj", Refused, "line 1: a point needs three numbers"},
    {"real_self_intersect.obj", Refused, "crosses itself in 338 places"},
    {"real_shark_quads.ply", Mended, "The surface was inside out and was turned.", 21487},
    {"real_sharp_sphere.off", Refused, "crosses itself in 60 places"},
    {"real_spider_nonmanifold.ply", Refused, "more than two faces meet"},
    {"real_stratocaster_94.ply", Refused, "crosses itself in 8166 places"},
    {"real_suzanne_open_quads.obj", Refused, "has 5 holes"},
    {"real_teapot_open.stl", Refused, "has 6 holes"},
    {"real_thingi_112932_2cc.stl", Loads, "", 2402.95},
    {"real_thingi_88566_8cc.stl", Loads, "", 48747.3},
    {"real_trim_star.off", Refused, "crosses itself in 10 places"},
    {"real_truck_nonmanifold.obj", Refused, "has 144 holes"},
    {"real_two_boxes_bad_union.ply", Refused, "crosses itself in 228 places"},
    {"real_whitespace.off", Loads, "", 12.3168},
    {"selfint_pushed_in.ply", Refused, "crosses itself in 122 places"},
    {"single_triangle.stl", Refused, "encloses no volume"},
    {"tetrahedron.obj", Loads, "", 0.166667},
    {"text_renamed.stl", Refused, "not an STL file: it is text"},
    {"text_starts_solid.stl", Refused, "no triangles"},
    {"tiny_1e-30.ply", Loads, "", 6.79729e-91},
    {"tiny_1e-6.stl", Loads, "", 6.79729e-19},
    {"trailing_garbage.stl", Loads, "", 0.679729},
    {"truncated.off", Refused, "line 238: a face of 3 corners needs as many numbers of points"},
    {"truncated_ascii.stl", Refused, "line 1124: a facet ends too early"},
    {"truncated_binary.ply", Refused, "face 843: a number is missing here"},
    {"truncated_header.ply", Refused, "line 6: "},
    {"truncated_header.stl", Refused, "not an STL file: it is text"},
    {"unknown_extension.xyz", Refused, "no format that"},
    {"unreferenced_vertices.ply", Loads, "", 0.679729},
    {"vertex_colours.obj", Loads, "", 4.04704},
    {"vertex_count_huge.ply", Refused, "announces 4000000000 times"},
    {"vertices_only.obj", Refused, "holds 162 points but no faces"},
    {"very_long_line.obj", Loads, "", 4.04704},
    {"zero_area_collinear.ply", Refused, "has no area"},
    {"zero_area_repeated_index.obj", Mended, "2 faces that used a point twice were removed.", 0.679729},
    {"zip_renamed.ply", Refused, "not a PLY file"},
    {"деталь 模型 (1).obj", Loads, "", 4.04704},
};
// clang-format on

class BadModel : public testing::TestWithParam<Expectation> {
protected:
    void SetUp() override {
        if (!test::badModels())
            GTEST_SKIP() << "MOLDWRIGHT_BAD_MODELS is not set";
    }
};

void expectRefusal(const Error& error, const Expectation& expected) {
    EXPECT_EQ(expected.outcome, Refused) << error.english();
    EXPECT_EQ(error.code, ErrorCode::BadInput) << error.english();
    EXPECT_NE(error.english().find(expected.words), std::string::npos) << error.english();
    EXPECT_NE(error.english().find(expected.file), std::string::npos) << error.english();
}

} // namespace

TEST_P(BadModel, HasItsOutcome) {
    const Expectation& expected = GetParam();
    const auto read = readMesh(*test::badModels() / expected.file);
    if (!read)
        return expectRefusal(read.error(), expected);
    const auto prepared = prepare(read->mesh, expected.file);
    if (!prepared)
        return expectRefusal(prepared.error(), expected);
    EXPECT_EQ(expected.outcome, prepared->repairs.empty() ? Loads : Mended);
    EXPECT_EQ(prepared->repairs.empty() ? "" : prepared->repairs[0].english(), expected.words);
    EXPECT_NEAR(volume(prepared->mesh), expected.volume, 1e-5 * expected.volume);
    EXPECT_TRUE(diagnose(prepared->mesh).usable());
}

INSTANTIATE_TEST_SUITE_P(Exchange, BadModel, testing::ValuesIn(expectations),
                         [](const testing::TestParamInfo<Expectation>& entry) {
                             std::string name = std::to_string(entry.index) + "_";
                             for (const char c : std::string(entry.param.file))
                                 name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                             return name;
                         });

TEST(BadModels, EveryFileHasAnExpectation) {
    if (!test::badModels())
        GTEST_SKIP() << "MOLDWRIGHT_BAD_MODELS is not set";
    std::set<std::string> listed;
    for (const Expectation& expected : expectations)
        listed.insert(expected.file);
    for (const auto& entry : fs::directory_iterator(*test::badModels()))
        EXPECT_TRUE(entry.path().extension() == ".md" || listed.contains(entry.path().filename().string()))
            << entry.path();
}

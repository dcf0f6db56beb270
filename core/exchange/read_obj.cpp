// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_readers.h"
#include "exchange/soup_builder.h"

namespace moldwright {

namespace {

std::string lineName(const TextLines& lines) {
    return "line " + std::to_string(lines.number());
}

/// The current line together with the lines that continue it after a backslash.
std::string_view continued(TextLines& lines, std::string& joined) {
    if (!lines.line().ends_with('\\'))
        return lines.line();
    joined.clear();
    bool more = true;
    while (more) {
        std::string_view part = lines.line();
        more = part.ends_with('\\');
        part.remove_suffix(more ? 1 : 0);
        joined.append(part).append(" ");
        more = more && lines.next();
    }
    return joined;
}

/// One face: corners as v, v/t, v//n or v/t/n; negative numbers count back from the last point.
bool readFace(std::string_view line, const std::string& where, SoupBuilder& builder) {
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
        const std::string_view index = word.substr(0, word.find('/'));
        const std::optional<long long> number = wholeNumber(index);
        if (!number || *number == 0)
            return builder.refuse(MW_TEXT("exchange",
                                          "{0}, {1}: a face's corner is “{2}”, not the number of a "
                                          "point from 1 on."),
                                  {where, shown(word)});
        if (!builder.addCorner(*number > 0 ? *number - 1 : builder.pointCount() + *number, where))
            return false;
    }
    return builder.endFace(where);
}

} // namespace

Result<ReadMesh> readObj(std::string_view bytes, const std::string& name) {
    SoupBuilder builder(name);
    if (!looksLikeText(bytes))
        builder.refuse(MW_TEXT("exchange", "{0} is not an OBJ file: it holds binary data."));
    TextLines lines(bytes);
    std::string joined;
    while (!builder.failed() && lines.next()) {
        const std::string where = lineName(lines);
        std::string_view line = continued(lines, joined);
        const std::string_view keyword = takeWord(line);
        if (keyword == "v")
            builder.addPoint(line, where);
        else if (keyword == "f")
            readFace(line, where, builder);
    }
    return std::move(builder).finish();
}

} // namespace moldwright

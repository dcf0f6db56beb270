// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/stencil_letters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

namespace moldwright {

namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

/// Middle lines of strokes in widths of a stroke: x,y from the lower left, a capital from 0 to 6, a semicolon
/// between strokes. Own design: no corner is round and no stroke meets another, so that a cutter or a
/// printer's nozzle makes each in one go.
const std::map<char32_t, std::string_view>& drawnLetters() {
    static const std::map<char32_t, std::string_view> letters = {
        {U'A', "0,0 1.8,6 3.2,6 5,0; 1.9,1.7 3.1,1.7"},
        {U'B', "0,0 0,6; 1.1,6 3,6 3.9,5.2 3.9,3.9 3.1,3 3.9,2.1 3.9,0.8 3,0 1.1,0; 1.1,3 1.7,3"},
        {U'C', "4,5 3,6 1,6 0,5 0,1 1,0 3,0 4,1"},
        {U'D', "0,0 0,6; 1.1,6 2.8,6 4,4.8 4,1.2 2.8,0 1.1,0"},
        {U'E', "4,6 0,6 0,0 4,0; 1.1,3 3.2,3"},
        {U'F', "4,6 0,6 0,0; 1.1,3 3.2,3"},
        {U'G', "4,5 3,6 1,6 0,5 0,1 1,0 3,0 4,1 4,2.9 2.3,2.9"},
        {U'H', "0,0 0,6; 4,0 4,6; 1.1,3 2.9,3"},
        {U'I', "0,0 0,6"},
        {U'J', "3,6 3,1 2,0 1,0 0,1"},
        {U'K', "0,0 0,6; 4,6 1.8,3.1 4,0"},
        {U'L', "0,6 0,0 3.6,0"},
        {U'M', "0,0 0,6; 5.2,0 5.2,6; 1.6,5 2.6,3 3.6,5"},
        {U'N', "0,0 0,6; 4.6,0 4.6,6; 1.55,4.5 3.05,1.5"},
        {U'O', "1.5,0 1,0 0,1 0,5 1,6 3.2,6 4.2,5 4.2,1 3.2,0 2.7,0"},
        {U'P', "0,0 0,6; 1.1,6 3,6 4,5.2 4,3.6 3,2.8 1.1,2.8"},
        {U'Q', "1.5,0 1,0 0,1 0,5 1,6 3.2,6 4.2,5 4.2,1 3.2,0 2.7,0; 1.9,2.4 2.7,1.6"},
        {U'R', "0,0 0,6; 1.1,6 3,6 4,5.2 4,3.8 3,3 1.1,3; 2.4,1.5 3.7,0"},
        {U'S', "4,5 3,6 1,6 0,5 0,3.9 0.9,3 3.1,3 4,2.1 4,1 3,0 1,0 0,1"},
        {U'T', "0,6 4.2,6; 2.1,4.9 2.1,0"},
        {U'U', "0,6 0,1 1,0 3.2,0 4.2,1 4.2,6"},
        {U'V', "0,6 1.8,0 3.2,0 5,6"},
        {U'W', "0,6 0.8,0 2.3,0 3.3,4.4 4.3,0 5.8,0 6.6,6"},
        {U'X', "0,0 4.4,6; 0,6 1.4,4.09; 3,1.91 4.4,0"},
        {U'Y', "0,6 2.1,3.1 4.2,6; 2.1,1.6 2.1,0"},
        {U'Z', "0,6 4,6 0,0 4,0"},
        {U'0', "1.3,0 0.7,0 0,0.9 0,5.1 0.7,6 2.7,6 3.4,5.1 3.4,0.9 2.7,0 2.1,0"},
        {U'1', "0,4.8 1.6,6 1.6,0"},
        {U'2', "0,5 1,6 3,6 4,5 4,3.9 0,0 4,0"},
        {U'3', "0,6 3,6 3.9,5.2 3.9,3.9 3.1,3 3.9,2.1 3.9,0.8 3,0 0,0; 0.7,3 1.7,3"},
        {U'4', "1.4,6 0,1.8 1.9,1.8; 3,6 3,0; 4.1,1.8 4.7,1.8"},
        {U'5', "3.8,6 0,6 0,3.4 3,3.4 4,2.5 4,0.9 3,0 0,0"},
        {U'6', "3.6,6 1,6 0,5 0,1 1,0 3,0 4,1 4,2.4 3.1,3.3 1.2,3.3"},
        {U'7', "0,6 4,6 1.4,0"},
        {U'8', "2.7,6 3.2,6 4,5.2 4,3.9 3.2,3 4,2.1 4,0.8 3.2,0 2.7,0; "
               "1.3,6 0.8,6 0,5.2 0,3.9 0.8,3 0,2.1 0,0.8 0.8,0 1.3,0"},
        {U'9', "0.4,0 3,0 4,1 4,5 3,6 1,6 0,5 0,3.6 0.9,2.7 2.8,2.7"},
        {U' ', ""},
        {U'-', "0,3 2.4,3"},
        {U'.', "0,-0.5 0,0.5"},
        {U',', "0.4,0.5 0,-1"},
        {U':', "0,1 0,2; 0,4 0,5"},
        {U'/', "0,-0.3 2.6,6.3"},
        {U'%', "0,-0.2 4.4,6.2; 0,5.4 1.2,5.4; 3.2,0.6 4.4,0.6"},
        {U'°', "0.9,4 0,4 0,6.2 2.2,6.2 2.2,5.1"},
        {U'#', "1.9,0 1.9,6; 4.7,0 4.7,6; 0,4.2 0.8,4.2; 0,1.8 0.8,1.8; 3,4.2 3.6,4.2; 3,1.8 3.6,1.8; "
               "5.8,4.2 6.6,4.2; 5.8,1.8 6.6,1.8"},
        {U'+', "2,1 2,5; 0,3 0.9,3; 3.1,3 4,3"},
        {U'(', "1.2,7 0,5.6 0,0.4 1.2,-1"},
        {U')', "0,7 1.2,5.6 1.2,0.4 0,-1"}};
    return letters;
}

/// Marks about the middle of their letter; those above it begin 0.6 over a capital.
const std::map<char32_t, std::string_view>& drawnMarks() {
    static const std::map<char32_t, std::string_view> marks = {{U'¨', "-1.2,7.1 -1.2,8.1; 1.2,7.1 1.2,8.1"},
                                                               {U'´', "-0.4,7.4 0.5,8.7"},
                                                               {U'`', "0.4,7.4 -0.5,8.7"},
                                                               {U'^', "-1.4,7.5 0,8.6 1.4,7.5"},
                                                               {U'~', "-1.5,7.6 -0.5,8.2 0.5,7.7 1.5,8.3"},
                                                               {U'°', "-0.5,7.6 0.5,7.6"},
                                                               {U'¸', "0,-1.1 0,-2.1"}};
    return marks;
}

constexpr double betweenLetters = 2.4; // from middle line to middle line
constexpr double spaceWidth = 0.6;
constexpr double linePitch = 11;

std::vector<PlanShape> strokesOf(std::string_view drawn) {
    std::vector<PlanShape> strokes;
    if (!drawn.empty())
        strokes.emplace_back();
    const char* end = drawn.data() + drawn.size();
    for (const char* at = drawn.data(); at != end;) {
        if (*at == ' ' || *at == ';') {
            if (*at++ == ';')
                strokes.emplace_back();
            continue;
        }
        Vector2d p = Vector2d::Zero();
        at = std::from_chars(at, end, p.x()).ptr + 1; // the comma
        at = std::from_chars(at, end, p.y()).ptr;
        strokes.back().push_back(p);
    }
    return strokes;
}

/// The letters of U+00C0 to U+00DE as a capital and its mark; a space for those that are not drawn.
constexpr std::u32string_view westernLetters =
    U"A`A´A^A~A¨A°  C¸E`E´E^E¨I`I´I^I¨  N~O`O´O^O~O¨    U`U´U^U¨Y´  ";

struct Character {
    char32_t letter = U' ';
    char32_t mark = U' ';
};

Character characterFor(char32_t code) {
    constexpr char32_t firstWestern = 0xC0;
    constexpr char32_t toSmall = 0x20;
    if ((code >= U'a' && code <= U'z') || (code >= firstWestern + toSmall && code <= 0xFE))
        code -= toSmall;
    if (code < firstWestern || code > 0xDE)
        return {code, U' '};
    const std::size_t at = 2 * (code - firstWestern);
    return westernLetters[at] == U' ' ? Character{code, U' '}
                                      : Character{westernLetters[at], westernLetters[at + 1]};
}

/// Code points of UTF-8; what is none counts as one of its own.
std::u32string codePoints(const std::string& text) {
    std::u32string codes;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
        char32_t code = more == 0 ? lead : lead & (0x3F >> more);
        for (std::size_t k = 1; k <= more && i + k < text.size(); ++k)
            code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3F);
        codes.push_back(code);
        i += more + 1;
    }
    return codes;
}

/// The character as it was written, for a sentence.
std::string written(char32_t code) {
    std::string bytes;
    if (code < 0x80)
        return {static_cast<char>(code)};
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    bytes.push_back(static_cast<char>((0xF0 << (3 - more) & 0xFF) | (code >> (6 * more))));
    for (int k = more - 1; k >= 0; --k)
        bytes.push_back(static_cast<char>(0x80 | (code >> (6 * k) & 0x3F)));
    return bytes;
}

/// A line's middle lines, beginning at x = 0, and how wide it is, both in widths of a stroke.
struct Line {
    std::vector<PlanShape> strokes;
    double width = 0;
};

Result<Line> lineOf(const std::string& text) {
    Line line;
    double x = 0;
    for (const char32_t code : codePoints(text)) {
        const Character character = characterFor(code);
        const auto drawn = drawnLetters().find(character.letter);
        if (drawn == drawnLetters().end())
            return failure(ErrorCode::Usage,
                           MW_TEXT("Mold",
                                   "There is no letter \"{0}\" for a plaque. There are A to Z, 0 to 9, "
                                   "letters with Western marks, and - . , : / % ° # + ( )."),
                           {written(code)});
        double width = drawn->second.empty() ? spaceWidth : 0;
        for (PlanShape& stroke : strokesOf(drawn->second)) {
            for (const Vector2d& p : stroke)
                width = std::max(width, p.x());
            line.strokes.push_back(movedPlan(std::move(stroke), {x, 0}));
        }
        if (character.mark != U' ')
            for (PlanShape& stroke : strokesOf(drawnMarks().at(character.mark)))
                line.strokes.push_back(movedPlan(std::move(stroke), {x + width / 2, 0}));
        line.width = x + width;
        x += width + betweenLetters;
    }
    return line;
}

/// To the left of a way.
Vector2d leftOf(const Vector2d& way) {
    return Vector2d(-way.y(), way.x()).normalized();
}

/// The points of one side of a line, to its left.
PlanShape leftSide(const PlanShape& line, double half) {
    PlanShape side{line.front() + half * leftOf(line[1] - line[0])};
    for (std::size_t k = 1; k + 1 < line.size(); ++k) {
        const Vector2d before = leftOf(line[k] - line[k - 1]);
        const Vector2d after = leftOf(line[k + 1] - line[k]);
        const double mitre = 1 / (1 + before.dot(after)); // (before + after)·mitre lies on both sides' lines
        const bool outside = before.x() * after.y() - before.y() * after.x() < 0;
        constexpr double longest = 2; // 60° between the ways
        if (outside && mitre > longest) {
            side.push_back(line[k] + half * before);
            side.push_back(line[k] + half * after);
        } else {
            side.push_back(line[k] + half * mitre * (before + after));
        }
    }
    side.push_back(line.back() + half * leftOf(line.back() - line[line.size() - 2]));
    return side;
}

} // namespace

PlanShape strokeOutline(const PlanShape& line, double width) {
    const PlanShape back(line.rbegin(), line.rend());
    PlanShape outline = leftSide(back, width / 2); // the right side, from the end to the beginning
    const PlanShape left = leftSide(line, width / 2);
    outline.insert(outline.end(), left.begin(), left.end());
    std::reverse(outline.begin(), outline.end());
    return outline;
}

Result<StencilText> stencilText(const std::vector<std::string>& lines, double height) {
    const double stroke = height * strokeOfHeight;
    StencilText text;
    for (std::size_t row = 0; row < lines.size(); ++row) {
        Result<Line> line = lineOf(lines[row]);
        if (!line)
            return std::unexpected(line.error());
        const Vector2d start(-line->width / 2, -linePitch * static_cast<double>(row));
        for (const PlanShape& middle : line->strokes) {
            PlanShape outline = strokeOutline(movedPlan(middle, start), 1);
            for (Vector2d& p : outline) {
                p *= stroke;
                text.box.extend(p);
            }
            text.strokes.push_back(std::move(outline));
        }
    }
    return text;
}

} // namespace moldwright

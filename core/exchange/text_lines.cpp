// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace moldwright {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t\v\f";

/// from_chars knows no leading plus.
std::string_view withoutPlus(std::string_view word) {
    const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
    return plus ? word.substr(1) : word;
}

} // namespace

TextLines::TextLines(std::string_view text) : m_rest(text) {
    if (m_rest.starts_with(byteOrderMark))
        m_rest.remove_prefix(byteOrderMark.size());
}

bool TextLines::next() {
    if (m_rest.empty())
        return false;
    const std::size_t end = std::min(m_rest.find_first_of("\r\n"), m_rest.size());
    m_line = m_rest.substr(0, end);
    m_rest.remove_prefix(end);
    m_rest.remove_prefix(m_rest.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, m_rest.size()));
    ++m_number;
    return true;
}

std::string_view takeWord(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

std::optional<double> realNumber(std::string_view word) {
    word = withoutPlus(word);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size() || word.empty())
        return std::nullopt;
    // Too small is as good as zero; too large is not a number one can use.
    if (error == std::errc::result_out_of_range)
        value = std::strtod(std::string(word).c_str(), nullptr);
    else if (error != std::errc())
        return std::nullopt;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<long long> wholeNumber(std::string_view word) {
    word = withoutPlus(word);
    long long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

std::string lowerCase(std::string_view word) {
    std::string lower(word);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::string shown(std::string_view foreign) {
    constexpr std::size_t most = 24;
    std::string text(foreign.substr(0, most));
    for (char& c : text)
        if (c < ' ' || c > '~')
            c = '?';
    return foreign.size() > most ? text + "…" : text;
}

bool looksLikeText(std::string_view bytes) {
    constexpr std::size_t sample = 4096;
    return bytes.substr(0, sample).find('\0') == std::string_view::npos;
}

} // namespace moldwright

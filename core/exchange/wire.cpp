// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/wire.h"

namespace moldwright {

void WireWriter::text(std::string_view value) {
    number(static_cast<std::int64_t>(value.size()));
    append(value.data(), value.size());
}

void WireWriter::message(const Message& value) {
    text(value.text);
    number(static_cast<std::int64_t>(value.arguments.size()));
    for (const std::string& argument : value.arguments)
        text(argument);
}

void WireWriter::error(const Error& value) {
    number(static_cast<std::int64_t>(value.code));
    message(value.message);
}

std::string_view WireReader::take(std::size_t size) {
    if (size > m_rest.size()) {
        m_whole = false;
        m_rest = {};
        return {};
    }
    const std::string_view taken = m_rest.substr(0, size);
    m_rest.remove_prefix(size);
    return taken;
}

std::size_t WireReader::count(std::size_t itemBytes) {
    const std::int64_t announced = number();
    if (announced >= 0 && static_cast<std::size_t>(announced) <= m_rest.size() / itemBytes)
        return static_cast<std::size_t>(announced);
    m_whole = false;
    m_rest = {};
    return 0;
}

std::int64_t WireReader::number() {
    std::int64_t value = 0;
    const std::string_view data = take(sizeof value);
    if (!data.empty())
        std::memcpy(&value, data.data(), sizeof value);
    return value;
}

std::string WireReader::text() {
    return std::string(take(count(1)));
}

Message WireReader::message() {
    Message value;
    value.text = text();
    const std::size_t arguments = count(sizeof(std::int64_t));
    for (std::size_t i = 0; i < arguments; ++i)
        value.arguments.push_back(text());
    return value;
}

Error WireReader::error() {
    Error value;
    const std::int64_t code = number();
    if (code < 0 || code > static_cast<std::int64_t>(ErrorCode::Internal))
        m_whole = false;
    else
        value.code = static_cast<ErrorCode>(code);
    value.message = message();
    return value;
}

} // namespace moldwright

#include "core/byte_stream.h"

#include "core/error.h"

namespace caustic {

namespace {

constexpr std::uint64_t longestText = std::uint64_t{1} << 20;

}  // namespace

std::uint64_t ByteWriter::sumWith(std::uint64_t sum, const void* bytes, std::size_t count) {
    const auto* const byte = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < count; ++i) sum = (sum ^ byte[i]) * 0x100000001b3ULL;
    return sum;
}

void ByteWriter::write(const void* bytes, std::size_t count) {
    sum_ = sumWith(sum_, bytes, count);
    out_->write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
}

void ByteWriter::putText(std::string_view text) {
    put(std::uint64_t{text.size()});
    write(text.data(), text.size());
}

void ByteWriter::seal() {
    put(std::uint64_t{sum_});
    sum_ = emptySum;
}

void ByteReader::read(void* bytes, std::size_t count) {
    in_->read(static_cast<char*>(bytes), static_cast<std::streamsize>(count));
    if (static_cast<std::size_t>(in_->gcount()) != count) refuse("", "is cut short");
    sum_ = ByteWriter::sumWith(sum_, bytes, count);
}

std::string ByteReader::getText() {
    const auto length = get<std::uint64_t>();
    if (length > longestText) refuse(std::to_string(length) + " bytes of text", "is damaged, or no such file at all");
    std::string text(length, '\0');
    read(text.data(), text.size());
    return text;
}

void ByteReader::expectText(std::string_view text, const std::string& what) {
    const std::string found = getText();
    if (found != text) refuse(found, "is of another " + what + ", not of '" + std::string(text) + "'");
}

void ByteReader::expect(std::int64_t value, const std::string& what) {
    const auto found = get<std::int64_t>();
    if (found != value) refuse(std::to_string(found), "is of another " + what + ", not of " + std::to_string(value));
}

void ByteReader::checkSeal() {
    const std::uint64_t sum = sum_;
    if (get<std::uint64_t>() != sum) refuse("", "is damaged: its bytes are not those that were written");
    sum_ = ByteWriter::emptySum;
}

void ByteReader::checkEnd() {
    if (in_->peek() != std::istream::traits_type::eof()) refuse("", "goes on after its end");
}

void ByteReader::refuse(const std::string& value, const std::string& reason) const {
    throw InputError({name_, 0}, value, reason);
}

}  // namespace caustic

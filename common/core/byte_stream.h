#pragma once

#include <bit>
#include <cstdint>
#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace caustic {

static_assert(std::endian::native == std::endian::little, "files of bytes are little-endian");

/// Writes numbers and text as the bytes that they are, for files that have to be read back exactly.
class ByteWriter {
public:
    /// The stream is kept by reference; it must be a binary one.
    explicit ByteWriter(std::ostream& out) : out_(&out) {}

    /// Writes numbers, or structs of numbers that have no gaps.
    template <typename T>
    void putAll(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        write(values.data(), values.size_bytes());
    }

    /// Writes one of them.
    template <typename T>
    void put(const T& value) {
        putAll(std::span<const T>(&value, 1));
    }

    /// Writes text: its length, then its bytes.
    void putText(std::string_view text);

    /// Writes a sum of all bytes since the beginning or the last seal, by which the reader knows that none has changed.
    void seal();

private:
    void write(const void* bytes, std::size_t count);

    std::ostream* out_;
    std::uint64_t sum_ = emptySum;

    friend class ByteReader;
    static constexpr std::uint64_t emptySum = 0xcbf29ce484222325ULL;
    // Source: Fowler, Noll, Vo: the FNV-1a hash, 64 bits.
    static std::uint64_t sumWith(std::uint64_t sum, const void* bytes, std::size_t count);
};

/// Reads what a ByteWriter wrote, in the same order. Whatever isn't as it was written is refused by an InputError that
/// names the file.
class ByteReader {
public:
    /// The stream is kept by reference.
    /// @param name  of the file, for messages
    ByteReader(std::istream& in, std::string name) : in_(&in), name_(std::move(name)) {}

    /// Reads as many numbers as there is room for.
    /// @throws InputError when the file is cut short
    template <typename T>
    void getAll(std::span<T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        read(values.data(), values.size_bytes());
    }

    /// Reads one.
    /// @throws InputError when the file is cut short
    template <typename T>
    T get() {
        T value;
        getAll(std::span<T>(&value, 1));
        return value;
    }

    /// Reads text.
    /// @throws InputError when the file is cut short, or the text is longer than a mebibyte
    std::string getText();

    /// Reads a text and refuses another one than this.
    /// @param what  the text is, in the message: "picture"
    void expectText(std::string_view text, const std::string& what);

    /// Reads a number and refuses another one than this.
    /// @param what  the number is, in the message: "version"
    void expect(std::int64_t value, const std::string& what);

    /// Checks the bytes read since the beginning or the last seal.
    /// @throws InputError when they aren't those that were written
    void checkSeal();

    /// Checks that nothing follows.
    /// @throws InputError when something does
    void checkEnd();

    /// Throws an InputError that names the file.
    [[noreturn]] void refuse(const std::string& value, const std::string& reason) const;

private:
    void read(void* bytes, std::size_t count);

    std::istream* in_;
    std::string name_;
    std::uint64_t sum_ = ByteWriter::emptySum;
};

}  // namespace caustic

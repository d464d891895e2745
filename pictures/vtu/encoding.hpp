// Binary arrays in VTK's XML files: base64 (RFC 4648), uncompressed or compressed by zlib block by
// block.
#pragma once

#include <span>
#include <string>

namespace kusabi::pictures {

/// Base64 of the bytes, with padding.
std::string base64(std::span<const char> bytes);

/// Text of a DataArray of format "binary" in a file whose header_type is UInt64: the number of
/// bytes, then the bytes, in one base64 text.
std::string plain_array(std::span<const char> bytes);

/// As plain_array, in a file with compressor="vtkZLibDataCompressor": the number of blocks, the
/// block size, the size of the last block (0: it is full) and the compressed size of each block;
/// then, as a separate base64 text, the compressed blocks.
/// @throws std::runtime_error if zlib fails
std::string packed_array(std::span<const char> bytes);

}  // namespace kusabi::pictures

// Numbers as bytes in the text of an XML file of VTK: base64 (RFC 4648), as they are or packed by
// zlib block by block.
#pragma once

#include <span>
#include <string>

namespace kusabi::pictures {

/// Base64 of the bytes, with padding.
std::string base64(std::span<const char> bytes);

/// The text of a DataArray of format "binary" in a file whose header_type is UInt64: the number of
/// bytes and the bytes, as one text.
std::string plain_array(std::span<const char> bytes);

/// The same in a file with compressor="vtkZLibDataCompressor": first the number of blocks, the size
/// of each, that of the last one (0: it is whole) and what each has been packed into; as a text of
/// its own the packed blocks.
/// @throws std::runtime_error if zlib fails
std::string packed_array(std::span<const char> bytes);

}  // namespace kusabi::pictures

#pragma once
/// Stands in for zlib, of which io/csv.cpp reads files with: plain ones only, since the page decompresses what it is given.
#include <cstdio>

struct gzFile_s {
  std::FILE* file;
};
using gzFile = gzFile_s*;
enum { Z_OK = 0, Z_ERRNO = -1, Z_BUF_ERROR = -5 };

inline gzFile gzopen(const char* path, const char* mode) {
  std::FILE* file = std::fopen(path, mode);
  return file ? new gzFile_s{file} : nullptr;
}
inline int gzread(gzFile file, void* to, unsigned size) {
  return static_cast<int>(std::fread(to, 1, size, file->file));
}
inline void gzerror(gzFile file, int* error) {
  *error = std::ferror(file->file) ? Z_ERRNO : Z_OK;
}
inline void gzclose_r(gzFile file) {
  std::fclose(file->file);
  delete file;
}

#include "programs/fmu/archive.hpp"

#include <minizip/zip.h>

#include "libcontact/base/error.hpp"

namespace hinge_fmu {

Archive::Archive(const std::filesystem::path& file)
    : file_(file.string()), zip_(zipOpen(file_.c_str(), APPEND_STATUS_CREATE)) {
  if (!zip_) throw contact::Error(file_ + ": cannot be made");
}

Archive::~Archive() {
  if (zip_) zipClose(zip_, nullptr);
}

void Archive::add(const std::string& name, const std::string& content) {
  zip_fileinfo info{};
  info.dosDate = 0x210000;         // the earliest date: 1980-01-01
  info.external_fa = 0644u << 16;  // permissions on Unix
  const auto size = static_cast<unsigned>(content.size());
  if (zipOpenNewFileInZip(zip_, name.c_str(), &info, nullptr, 0, nullptr, 0,
                          nullptr, Z_DEFLATED,
                          Z_DEFAULT_COMPRESSION) != ZIP_OK ||
      zipWriteInFileInZip(zip_, content.data(), size) != ZIP_OK ||
      zipCloseFileInZip(zip_) != ZIP_OK) {
    throw contact::Error(file_ + ": cannot be written");
  }
}

void Archive::close() {
  const int status = zipClose(zip_, nullptr);
  zip_ = nullptr;
  if (status != ZIP_OK) throw contact::Error(file_ + ": cannot be written");
}

}  // namespace hinge_fmu

// SPDX-License-Identifier: MIT
/// \file
/// The folder of a catalog: catalog.json, sorted like the lists, and the minimizers' files.
#pragma once

#include <optional>
#include <string>

#include "catalog/catalog_json.h"

namespace umbilic::cli {

class CatalogFolder {
 public:
  /// Reads the folder. Content of another version is ignored. Errors name the file that cannot be read.
  static Result<CatalogFolder> open(std::string path);

  /// The stored entry or start, or null.
  const catalog::Json* entry(const catalog::CatalogShape& shape, const catalog::CatalogFunctional& functional) const;
  const catalog::Json* start(const catalog::Start& start) const;

  /// Whether the entry and its file exist, with a second opinion, and were computed with these settings.
  bool has(const catalog::CatalogShape& shape, const catalog::CatalogFunctional& functional,
           const catalog::EntrySettings& settings) const;
  bool has(const catalog::Start& start, const catalog::EntrySettings& settings) const;

  /// The stored minimizer's report; errors name the file.
  Result<std::string> minimizer(const catalog::Json& entry) const;

  /// Adds or replaces an entry, in the files too.
  std::optional<Error> keep(const catalog::Entry& entry);
  std::optional<Error> keep(const catalog::StartResult& start);

 private:
  explicit CatalogFolder(std::string path);
  std::optional<Error> write() const;

  std::string path_;
  catalog::Json catalog_;
};

}  // namespace umbilic::cli

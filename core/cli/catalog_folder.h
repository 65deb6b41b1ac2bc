// SPDX-License-Identifier: MIT
/// \file
/// The folder of a catalog: catalog.json, kept in the order of the lists, and the minimizers' files.
#pragma once

#include <optional>
#include <string>

#include "catalog/catalog_json.h"

namespace umbilic::cli {

class CatalogFolder {
 public:
  /// What the folder holds so far; nothing of another version's. Errors name the file that cannot be read.
  static Result<CatalogFolder> open(std::string path);

  /// The stored entry or start, or null.
  const Json* entry(const CatalogShape& shape, const CatalogFunctional& functional) const;
  const Json* start(const Start& start) const;

  /// Whether the entry is there with its file and was computed with these settings.
  bool has(const CatalogShape& shape, const CatalogFunctional& functional, const EntrySettings& settings) const;
  bool has(const Start& start, const EntrySettings& settings) const;

  /// The stored minimizer; errors name the file.
  Result<Json> minimizer(const Json& entry) const;

  /// Replaces what is there, in the files as well.
  std::optional<Error> keep(const Entry& entry);
  std::optional<Error> keep(const StartResult& start);

 private:
  explicit CatalogFolder(std::string path);
  std::optional<Error> write() const;

  std::string path_;
  Json catalog_;
};

}  // namespace umbilic::cli

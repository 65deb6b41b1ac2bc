// SPDX-License-Identifier: MIT
/// \file
/// Finds entries, and writes each as soon as it is computed, so that an interrupted catalog can be continued.
#include "cli/catalog_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/files.h"
#include "cli/version.h"
#include "problem/text.h"

namespace umbilic::cli {

using namespace catalog;

namespace {

namespace fs = std::filesystem;

Result<Json> read_json(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  Json json = Json::parse(*text, nullptr, false);
  if (json.is_discarded()) return Error{fmt::format("{} is not JSON", path)};
  return json;
}

/// Index in the order of rows and columns.
std::size_t place(const Json& item) {
  const auto index = [](const auto& list, const Json& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const auto& known) { return name == known.name; });
    return static_cast<std::size_t>(found - list.begin());
  };
  return index(catalog_shapes(), item.at("shape")) * (catalog_functionals().size() + 1) +
         index(catalog_functionals(), item.at("functional"));
}

bool same(const Json& a, const Json& b) {
  return a.at("shape") == b.at("shape") && a.at("functional") == b.at("functional") &&
         a.value("thickness", Json()) == b.value("thickness", Json());
}

void insert(Json& list, Json item) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Json& other) { return same(other, item); });
  if (found != list.end()) {
    *found = std::move(item);
    return;
  }
  const auto later = [](const Json& a, const Json& b) {
    return std::pair(place(a), a.value("thickness", 0.0)) < std::pair(place(b), b.value("thickness", 0.0));
  };
  list.push_back(std::move(item));
  std::sort(list.begin(), list.end(), later);
}

const Json* find(const Json& list, const Json& like) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Json& item) { return same(item, like); });
  return found == list.end() ? nullptr : &*found;
}

}  // namespace

CatalogFolder::CatalogFolder(std::string path) : path_(std::move(path)), catalog_(empty_catalog(version())) {}

Result<CatalogFolder> CatalogFolder::open(std::string path) {
  CatalogFolder folder(std::move(path));
  std::error_code error;
  fs::create_directories(folder.path_, error);
  const std::string file = (fs::path(folder.path_) / "catalog.json").string();
  if (!fs::exists(file, error)) return folder;
  const Result<Json> stored = read_json(file);
  if (!stored) return stored.error();
  if (stored->value("version", "") != version()) return folder;
  for (const char* list : {"entries", "starts"}) folder.catalog_[list] = stored->value(list, Json::array());
  return folder;
}

const Json* CatalogFolder::entry(const CatalogShape& shape, const CatalogFunctional& functional) const {
  return find(catalog_["entries"], {{"shape", shape.name}, {"functional", functional.name}});
}

const Json* CatalogFolder::start(const Start& start) const {
  return find(catalog_["starts"],
              {{"shape", start.shape}, {"functional", start.functional}, {"thickness", start.thickness}});
}

bool CatalogFolder::has(const CatalogShape& shape, const CatalogFunctional& functional,
                        const EntrySettings& settings) const {
  const Json* stored = entry(shape, functional);
  if (!stored || stored->at("settings") != json_of(settings) || !stored->contains("second_opinion")) return false;
  const Result<std::string> report = minimizer(*stored);
  return report && parse_report(*report).ok();
}

bool CatalogFolder::has(const Start& wanted, const EntrySettings& settings) const {
  const Json* stored = start(wanted);
  return stored && stored->at("level") == settings.run.last_level;
}

Result<std::string> CatalogFolder::minimizer(const Json& entry) const {
  return read_file((fs::path(path_) / entry.at("minimizer").get<std::string>()).string());
}

std::optional<Error> CatalogFolder::keep(const Entry& entry) {
  Json json = json_of(entry);
  const fs::path file = fs::path(path_) / json.at("minimizer").get<std::string>();
  if (auto error = write_file(file.string(), minimizer_text(entry, version()))) return error;
  if (const std::optional<std::string> below = below_text(entry, version())) {
    const fs::path lower = fs::path(path_) / json.at("below").at("minimizer").get<std::string>();
    if (auto error = write_file(lower.string(), *below)) return error;
  }
  insert(catalog_["entries"], std::move(json));
  return write();
}

std::optional<Error> CatalogFolder::keep(const StartResult& start) {
  insert(catalog_["starts"], json_of(start));
  return write();
}

std::optional<Error> CatalogFolder::write() const {
  return write_file((fs::path(path_) / "catalog.json").string(), catalog_.dump(1) + "\n");
}

}  // namespace umbilic::cli

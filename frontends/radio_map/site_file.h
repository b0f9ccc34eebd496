#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_SITE_FILE_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_SITE_FILE_H_

#include <string>

#include "frontends/radio_map/site.h"

namespace walkgraph {

// A site as one binary file: the magic "WALKGRAPHSITE\n", a format version, the length and the
// FNV-1a checksum of the content, then the content (little-endian; strings and vectors with their
// lengths before them). A site that is read and written again has the same bytes.

std::string SerializeSite(const Site& site);

// `name` stands for the file in messages. Throws InputError where the bytes are no site, are cut or
// damaged, or were written by another format version.
Site ParseSite(const std::string& bytes, const std::string& name);

// Writes beside `path` and renames. Throws std::runtime_error where the file cannot be written.
void WriteSiteFile(const Site& site, const std::string& path);

// Throws InputError as ParseSite(), or where the file cannot be read.
Site ReadSiteFile(const std::string& path);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_SITE_FILE_H_

#pragma once
#include "site/draft.hpp"

#include <nlohmann/json.hpp>

namespace course {

/// What a reader can search for on a page: one document for each part of it, from heading to heading, with its address
/// and its words. Formulas are written in plain characters.
nlohmann::json search_documents(const Draft &draft);

} // namespace course

#pragma once
#include "context/context.hpp"

namespace legacy_gl {

void save_attributes(Context& context, GLbitfield mask, SavedAttributes& level);
/// Stores what differs, by way of the setters' comparisons: what is the same again costs nothing at
/// the next draw.
void restore_attributes(Context& context, const SavedAttributes& level);

void save_client_attributes(const Context& context, GLbitfield mask, SavedClientAttributes& level);
void restore_client_attributes(Context& context, const SavedClientAttributes& level);

}  // namespace legacy_gl

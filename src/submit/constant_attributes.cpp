#include "submit/constant_attributes.hpp"

#include "driver/driver_objects.hpp"
#include "record/current_normal.hpp"
#include "shadergen/attributes.hpp"

namespace legacy_gl {

void set_constant_attributes(const Context& context, std::uint16_t fields, unsigned texcoords) {
  const Driver& driver = context.driver->functions;
  const CurrentValues& current = context.current;
  if (fields & kFieldNormal) {
    const glm::vec4 normal(normal_to_draw(context), 1);
    driver.VertexAttrib4fv(kLocationNormal, &normal[0]);
  }
  if (fields & kFieldColor) driver.VertexAttrib4fv(kLocationColor, &current.color[0]);
  if (fields & kFieldSecondaryColor)
    driver.VertexAttrib4fv(kLocationSecondaryColor, &current.secondary_color[0]);
  if (fields & kFieldFogCoord) {
    const glm::vec4 coordinate(current.fog_coordinate, 0, 0, 1);
    driver.VertexAttrib4fv(kLocationFogCoord, &coordinate[0]);
  }
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
    if (texcoords & 1u << unit)
      driver.VertexAttrib4fv(texcoord_location(unit), &current.texture_coordinates[unit][0]);
}

}  // namespace legacy_gl

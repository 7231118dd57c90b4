package org.pendant.controller.device;

import java.util.Optional;
import org.pendant.cell.BodyProbe;
import org.pendant.controller.world.ContactWorld;

/** Zone watch: whether a tool centre point or a body is in a zone. */
final class ZoneWatch {
  private final Zone zone;
  private final ToolPlaces tools;
  private final Optional<BodyProbe> bodies;

  ZoneWatch(Zone zone, ToolPlaces tools, ContactWorld world) {
    this.zone = zone;
    this.tools = tools;
    bodies = zone.watch(world);
  }

  boolean sees() {
    return tools.anyIn(zone) || (bodies.isPresent() && bodies.get().sees());
  }
}

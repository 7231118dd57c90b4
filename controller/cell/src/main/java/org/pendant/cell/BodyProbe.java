package org.pendant.cell;

import java.util.List;
import java.util.function.LongSupplier;
import org.ode4j.ode.DContactGeomBuffer;
import org.ode4j.ode.DGeom;

/** Body probe: a part of space that sees whether a free body is in it, and changes nothing. */
public final class BodyProbe {
  private final DGeom space;
  private final HullProbe hulls;
  private final List<CellBody> bodies;
  private final LongSupplier changes;
  private final DContactGeomBuffer found = new DContactGeomBuffer(1);
  private long known = -1;
  private boolean sees;

  BodyProbe(DGeom space, HullProbe hulls, List<CellBody> bodies, LongSupplier changes) {
    this.space = space;
    this.hulls = hulls;
    this.bodies = bodies;
    this.changes = changes;
  }

  /** Whether there is a free body in it now. */
  public boolean sees() {
    if (known != changes.getAsLong()) {
      known = changes.getAsLong();
      sees = look();
    }
    return sees;
  }

  private boolean look() {
    for (int i = 0; i < bodies.size(); i++) {
      CellBody body = bodies.get(i);
      if (body.free() && body.present && in(body)) {
        return true;
      }
    }
    return false;
  }

  private boolean in(CellBody body) {
    for (BodyPart part : body.parts) {
      if (!space.getAABB().isDisjoint(part.geom.getAABB()) && in(part)) {
        return true;
      }
    }
    return false;
  }

  private boolean in(BodyPart part) {
    return part.hull()
        ? hulls.holds(part.solid())
        : PhysicsLibrary.touch(space, part.geom, 1, found) > 0;
  }
}

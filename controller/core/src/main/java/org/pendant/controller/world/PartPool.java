package org.pendant.controller.world;

/** Part pool: an object of the scene and copies of it, some of which are there. */
public final class PartPool {
  private final FreeBodies among;
  private final int[] parts;

  PartPool(FreeBodies among, int[] parts) {
    this.among = among;
    this.parts = parts;
  }

  /** Whether all of them are there. */
  public boolean empty() {
    for (int part : parts) {
      if (!among.bodies().present(part)) {
        return false;
      }
    }
    return true;
  }

  /** Puts one more where the object was at first; answers whether there was one, and room. */
  public boolean put() {
    for (int part : parts) {
      if (!among.bodies().present(part)) {
        return among.putBack(part);
      }
    }
    return false;
  }
}

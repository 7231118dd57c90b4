package org.pendant.controller.device;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.pendant.models.pose.Pose;

/**
 * Tool places: where the tool centre points of all arms in a cell are, in the frame of the cell.
 * They are reckoned once a frame, however many sensors look, and not at all while none does.
 */
public final class ToolPlaces {
  private final List<Supplier<Pose>> tools = new ArrayList<>();
  private final List<Pose> now = new ArrayList<>();

  /** Those of no arm yet. */
  public ToolPlaces() {}

  /** Adds the tool of an arm. */
  public void add(Supplier<Pose> tcpInCell) {
    tools.add(tcpInCell);
  }

  /** A frame begins: arms may have moved. */
  void beginFrame() {
    now.clear();
  }

  /** Whether a tool centre point is in a zone. */
  boolean anyIn(Zone zone) {
    for (int i = 0; i < tools.size(); i++) {
      if (now.size() == i) {
        now.add(tools.get(i).get());
      }
      Pose tcp = now.get(i);
      if (zone.holds(tcp.x(), tcp.y(), tcp.z())) {
        return true;
      }
    }
    return false;
  }
}

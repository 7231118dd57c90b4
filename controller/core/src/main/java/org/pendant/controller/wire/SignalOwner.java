package org.pendant.controller.wire;

/** Signal owner: a device, or an arm, whose signals others in the cell are wired to. */
@FunctionalInterface
public interface SignalOwner {
  /**
   * One of its signals.
   *
   * @param group name of a group that it has
   * @param index a number that the group has
   */
  SignalLine line(String group, int index);
}

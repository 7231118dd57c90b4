package org.pendant.controller.wire;

/**
 * Cell signal: a signal that a device or a rule is wired to, by its name.
 *
 * @param owner whose it is: a device or another arm; empty for the controller of the cell
 * @param group such as {@code digital_out} or {@code coil}
 * @param index its number in the group
 */
public record CellSignal(String owner, String group, int index) {
  /** As files have it, such as {@code digital_out[0]} or {@code plc.coil[1]}. */
  @Override
  public String toString() {
    return (owner.isEmpty() ? "" : owner + ".") + group + "[" + index + "]";
  }
}

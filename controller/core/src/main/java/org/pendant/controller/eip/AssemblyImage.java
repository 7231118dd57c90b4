package org.pendant.controller.eip;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Assembly image: the configured assemblies at the end of a frame. Of the two that are built in
 * only that from scanner to robot is among them, where a PLC of the cell has written it last.
 *
 * @param pairs in the order in which they were configured
 * @param toPlc what programs have written, by instance
 * @param fromPlc what the scanner has written, by instance
 */
public record AssemblyImage(
    List<AssemblyPair> pairs,
    Map<Integer, AssemblyData> toPlc,
    Map<Integer, AssemblyData> fromPlc) {
  /** No assembly. */
  public static final AssemblyImage EMPTY = new AssemblyImage(List.of(), Map.of(), Map.of());

  /** Copies list and maps. */
  public AssemblyImage {
    pairs = List.copyOf(pairs);
    toPlc = Map.copyOf(toPlc);
    fromPlc = Map.copyOf(fromPlc);
  }

  /** What the robot sends by an instance. */
  public Optional<AssemblyData> toPlc(int instance) {
    return Optional.ofNullable(toPlc.get(instance));
  }

  /** What the robot has got by an instance. */
  public Optional<AssemblyData> fromPlc(int instance) {
    return Optional.ofNullable(fromPlc.get(instance));
  }
}

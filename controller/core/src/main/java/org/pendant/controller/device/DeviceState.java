package org.pendant.controller.device;

import java.util.List;
import org.pendant.controller.wire.SignalGroupState;

/**
 * State of a device of the cell at one moment.
 *
 * @param name what it is called
 * @param kind what it is, for people
 * @param strokeM how far its fingers, its door or what is on its rail go; 0 where it has none
 * @param openingM how far they are open
 * @param forceN how hard they press on a part; 0 where they hold none
 * @param on whether it holds a part, or sees something
 * @param maxPartWidthM how wide a part may be that is put into it; 0 where it holds none
 * @param partWidthM how wide the part is that is there for it to hold; 0 for none
 * @param port at which programs reach it by a socket; 0 for none
 * @param procedurePort at which they call its procedures; 0 for none
 * @param signals that others are wired to; none for most devices
 */
public record DeviceState(
    String name,
    String kind,
    double strokeM,
    double openingM,
    double forceN,
    boolean on,
    double maxPartWidthM,
    double partWidthM,
    int port,
    int procedurePort,
    List<SignalGroupState> signals) {
  /** Copies the list. */
  public DeviceState {
    signals = List.copyOf(signals);
  }

  /** A device without procedures and signals. */
  public DeviceState(
      String name,
      String kind,
      double strokeM,
      double openingM,
      double forceN,
      boolean on,
      double maxPartWidthM,
      double partWidthM,
      int port) {
    this(name, kind, strokeM, openingM, forceN, on, maxPartWidthM, partWidthM, port, 0, List.of());
  }
}

package org.pendant.desktop.io;

import org.pendant.controller.device.DeviceState;
import org.pendant.desktop.unit.DisplayUnit;

/**
 * Device row: a device of the cell as it is shown.
 *
 * @param name what it is called
 * @param kind what it is
 * @param doing what it is at
 * @param box what its box does
 * @param boxOn whether that is so
 */
public record DeviceRow(String name, String kind, String doing, Box box, boolean boxOn) {
  private static final String DOOR = "door";
  private static final String RAIL = "rail";
  private static final String LIMIT_SWITCH = "limit switch";
  private static final String BUTTON = "button";

  /**
   * A device as it is now.
   *
   * @param length in which lengths are shown
   */
  public static DeviceRow of(DeviceState device, DisplayUnit length) {
    Box box = box(device);
    return new DeviceRow(
        device.name(),
        device.kind(),
        doing(device, length),
        box,
        box == Box.ONLINE ? device.on() : device.partWidthM() > 0);
  }

  /** What people can do to a device. */
  public enum Box {
    NONE(""),
    PART("Part"),
    PRESS("Press"),
    ONLINE("Online");

    private final String text;

    Box(String text) {
      this.text = text;
    }

    /** What is beside it. */
    public String text() {
      return text;
    }
  }

  private static Box box(DeviceState device) {
    if (!DeviceSignals.online(device).isEmpty()) {
      return Box.ONLINE;
    }
    if (device.maxPartWidthM() == 0) {
      return Box.NONE;
    }
    return device.kind().equals(LIMIT_SWITCH) || device.kind().equals(BUTTON)
        ? Box.PRESS
        : Box.PART;
  }

  private static String doing(DeviceState device, DisplayUnit length) {
    if (box(device) == Box.ONLINE) {
      return device.on() ? "On the network" : "Off the network";
    }
    if (device.strokeM() == 0) {
      return switch (device.kind()) {
        case "camera" -> device.on() ? "Sees a part" : "Sees nothing";
        case "lamp" -> device.on() ? "Lit" : "Not lit";
        case "belt" -> device.on() ? "Runs" : "Stands still";
        case "source" -> device.on() ? "A part comes" : "Waits";
        case "sink" -> device.on() ? "Takes a part" : "Waits";
        case LIMIT_SWITCH, BUTTON -> device.on() ? "Pressed" : "Not pressed";
        default ->
            device.maxPartWidthM() == 0
                ? device.on() ? "Sees something" : "Sees nothing"
                : device.on() ? "Holds a part" : "Holds nothing";
      };
    }
    if (device.kind().equals(DOOR)) {
      double share = device.openingM() / device.strokeM();
      return share <= 0 ? "Closed" : share >= 1 ? "Open" : Math.round(100 * share) + " % open";
    }
    if (device.kind().equals(RAIL)) {
      return "At " + length.text(device.openingM()) + " of " + length.reading(device.strokeM());
    }
    String opening = length.reading(device.openingM());
    return device.on()
        ? opening + ", holds a part with " + Math.round(device.forceN()) + " N"
        : opening + " open";
  }
}

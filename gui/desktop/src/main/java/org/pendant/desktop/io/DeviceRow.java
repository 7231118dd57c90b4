package org.pendant.desktop.io;

import java.util.Locale;
import org.pendant.controller.device.DeviceState;

/**
 * Device row: a device of the cell as it is shown.
 *
 * @param name what it is called
 * @param kind what it is
 * @param doing what it is at
 * @param takesPart whether people can put a part into it
 * @param hasPart whether there is one
 */
public record DeviceRow(
    String name, String kind, String doing, boolean takesPart, boolean hasPart) {
  private static final double MM = 1e-3;
  private static final String DOOR = "door";
  private static final String LIMIT_SWITCH = "limit switch";
  private static final String BUTTON = "button";

  /** A device as it is now. */
  public static DeviceRow of(DeviceState device) {
    return new DeviceRow(
        device.name(), device.kind(), doing(device), device.mostM() > 0, device.partM() > 0);
  }

  /** Whether people press it, and put no part into it. */
  boolean pressable() {
    return kind.equals(LIMIT_SWITCH) || kind.equals(BUTTON);
  }

  private static String doing(DeviceState device) {
    if (device.strokeM() == 0) {
      return switch (device.kind()) {
        case "camera" -> device.on() ? "Sees a part" : "Sees nothing";
        case "lamp" -> device.on() ? "Lit" : "Not lit";
        case "belt" -> device.on() ? "Runs" : "Stands still";
        case "source" -> device.on() ? "A part comes" : "Waits";
        case "sink" -> device.on() ? "Takes a part" : "Waits";
        case LIMIT_SWITCH, BUTTON -> device.on() ? "Pressed" : "Not pressed";
        default ->
            device.mostM() == 0
                ? device.on() ? "Sees something" : "Sees nothing"
                : device.on() ? "Holds a part" : "Holds nothing";
      };
    }
    if (device.kind().equals(DOOR)) {
      return Math.round(100 * device.openingM() / device.strokeM()) + " % open";
    }
    String opening = String.format(Locale.ROOT, "%.1f mm", device.openingM() / MM);
    return device.on()
        ? opening + ", holds a part with " + Math.round(device.forceN()) + " N"
        : opening + " open";
  }
}

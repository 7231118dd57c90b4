package org.pendant.desktop.io;

import java.util.Locale;
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

  /** What it does, within a sentence. */
  public String doingInSentence() {
    return doing.isEmpty()
        ? ""
        : doing.substring(0, 1).toLowerCase(Locale.ROOT) + doing.substring(1);
  }

  /** What people can do to a device. */
  public enum Box {
    NONE(""),
    PART(IoTexts.text("partBox")),
    PRESS(IoTexts.text("pressBox")),
    ONLINE(IoTexts.text("onlineBox"));

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
      return device.on() ? IoTexts.text("onTheNetwork") : IoTexts.text("offTheNetwork");
    }
    if (device.strokeM() == 0) {
      return switch (device.kind()) {
        case "camera" -> device.on() ? IoTexts.text("seesAPart") : IoTexts.text("seesNothing");
        case "lamp" -> device.on() ? IoTexts.text("lit") : IoTexts.text("notLit");
        case "belt" -> device.on() ? IoTexts.text("runs") : IoTexts.text("standsStill");
        case "source" -> device.on() ? IoTexts.text("aPartComes") : IoTexts.text("waits");
        case "sink" -> device.on() ? IoTexts.text("takesAPart") : IoTexts.text("waits");
        case LIMIT_SWITCH, BUTTON ->
            device.on() ? IoTexts.text("pressed") : IoTexts.text("notPressed");
        default ->
            device.maxPartWidthM() == 0
                ? device.on() ? IoTexts.text("seesSomething") : IoTexts.text("seesNothing")
                : device.on() ? IoTexts.text("holdsAPart") : IoTexts.text("holdsNothing");
      };
    }
    if (device.kind().equals(DOOR)) {
      double share = device.openingM() / device.strokeM();
      return share <= 0
          ? IoTexts.text("closed")
          : share >= 1
              ? IoTexts.text("open")
              : IoTexts.text("openPercent", Math.round(100 * share));
    }
    if (device.kind().equals(RAIL)) {
      return IoTexts.text(
          "railAt", length.text(device.openingM()), length.reading(device.strokeM()));
    }
    String opening = length.reading(device.openingM());
    return device.on()
        ? IoTexts.text("holdsAPartWithN", opening, Math.round(device.forceN()))
        : IoTexts.text("openingOpen", opening);
  }
}

package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

/**
 * Wire port: what of a device a wire ends at.
 *
 * @param device name of the device
 * @param key of the field that says where the wire goes
 * @param title of the port
 * @param help what it is for, in words behind its title
 * @param way which way the wire leads
 * @param required whether there must be a wire
 * @param signal where its wire goes; empty for none
 * @param fixed whether it is wired elsewhere, as text
 */
record WirePort(
    String device,
    String key,
    String title,
    String help,
    Way way,
    boolean required,
    String signal,
    boolean fixed) {
  /** Which way a wire leads. */
  enum Way {
    /** From the device: it sets an input of the controller. */
    TELLS,
    /** To the device: it watches a signal. */
    WATCHES,
    /** From the device to an encoder, which it turns. */
    TURNS
  }

  /** Whether it is the same place of the same device, wherever the wire goes. */
  boolean isAt(WirePort other) {
    return device.equals(other.device) && key.equals(other.key) && fixed == other.fixed;
  }

  boolean wired() {
    return !signal.isEmpty();
  }

  /** Why no wire can go from here to a signal; empty if one can. */
  String refusal(WireSignal to) {
    if (fixed) {
      return text("rulesAreChangedAsTextOn");
    }
    boolean fits =
        switch (way) {
          case TELLS -> to.kind() == WireSignal.Kind.INPUT;
          case WATCHES -> to.kind() != WireSignal.Kind.ENCODER;
          case TURNS -> to.kind() == WireSignal.Kind.ENCODER;
        };
    if (fits) {
      return "";
    }
    String what = to.kind().words();
    return switch (way) {
      case TELLS -> text("onlyToInput", title, device, to.name(), what);
      case WATCHES -> text("onlyToSignal", title, device, to.name(), what);
      case TURNS -> text("onlyToEncoder", device, to.name(), what);
    };
  }

  /** Why its wire cannot be taken away; empty if it can. */
  String removalRefusal() {
    if (fixed) {
      return text("rulesAreChangedAsTextOn");
    }
    return required ? text("ofMustHaveAWireDrag", title, device) : "";
  }
}

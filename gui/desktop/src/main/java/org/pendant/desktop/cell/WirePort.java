package org.pendant.desktop.cell;

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
      return "rules are changed as text, on the page Forms";
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
    return switch (way) {
          case TELLS -> title + " of " + device + " is set by the device: it goes to an input, ";
          case WATCHES -> title + " of " + device + " watches a level: it goes to a signal, ";
          case TURNS -> device + " turns an encoder, ";
        }
        + to.name()
        + " is "
        + to.kind().words();
  }

  /** Why its wire cannot be taken away; empty if it can. */
  String removalRefusal() {
    if (fixed) {
      return "rules are changed as text, on the page Forms";
    }
    return required
        ? title + " of " + device + " must have a wire: drag it to another signal instead"
        : "";
  }
}

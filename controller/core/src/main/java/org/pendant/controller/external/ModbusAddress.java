package org.pendant.controller.external;

import static org.pendant.controller.external.ExternalTexts.text;

/**
 * Modbus address: where a device listens.
 *
 * @param host name or address, one {@code char} a byte
 * @param port 1 to 65535
 */
public record ModbusAddress(String host, int port) {
  /** The port of devices that name none. */
  public static final int STANDARD_PORT = 502;

  private static final int MAX_PORT = 65_535;

  /**
   * Reads {@code host}, {@code host:port} or, for IPv6, {@code [host]:port} (manual 18.18).
   *
   * @throws IllegalArgumentException when it is none of these; the message says what it must be
   */
  public static ModbusAddress parse(String text) {
    int colon = text.lastIndexOf(':');
    boolean bracketed = text.startsWith("[");
    boolean plainIpv6 = !bracketed && text.indexOf(':') != colon;
    if (colon < 0 || plainIpv6 || (bracketed && text.endsWith("]"))) {
      return new ModbusAddress(host(text), STANDARD_PORT);
    }
    String port = text.substring(colon + 1);
    if (!port.matches("[0-9]{1,5}")
        || Integer.parseInt(port) < 1
        || Integer.parseInt(port) > MAX_PORT) {
      throw new IllegalArgumentException(text("port"));
    }
    return new ModbusAddress(host(text.substring(0, colon)), Integer.parseInt(port));
  }

  private static String host(String text) {
    boolean bracketed = text.startsWith("[") && text.endsWith("]");
    String host = bracketed ? text.substring(1, text.length() - 1) : text;
    if (host.isBlank()) {
      throw new IllegalArgumentException(text("notEmpty"));
    }
    return host;
  }

  /** Host and port with a colon between. */
  @Override
  public String toString() {
    return (host.indexOf(':') >= 0 ? "[" + host + "]" : host) + ":" + port;
  }
}

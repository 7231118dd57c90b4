package org.pendant.controller.device;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Own address of the controller, by which programs reach what is on it. */
final class OwnAddress {
  private static final Pattern URL = Pattern.compile("(?:http://)?([^:/]+):(\\d{1,5})(?:/.*)?");

  private OwnAddress() {}

  /** Whether it is this controller. */
  static boolean isHost(String host) {
    return host.equals("localhost") || host.startsWith("127.");
  }

  /** The port of an address on this controller; 0 for any other address. */
  static int portOf(String url) {
    Matcher parts = URL.matcher(url);
    return parts.matches() && isHost(parts.group(1)) ? Integer.parseInt(parts.group(2)) : 0;
  }
}

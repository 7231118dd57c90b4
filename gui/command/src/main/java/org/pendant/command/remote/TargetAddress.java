package org.pendant.command.remote;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Target address: where the ports of a robot are.
 *
 * @param host its name or address
 * @param offset what is added to every port
 */
public record TargetAddress(String host, int offset) {
  private static final int DASHBOARD = 29999;
  private static final int PRIMARY = 30001;
  private static final int RTDE = 30004;
  private static final int MAX_OFFSET = 65_535 - RTDE;
  private static final Pattern FORM =
      Pattern.compile("(?:\\[([0-9a-fA-F:.%]+)]|([^:\\[\\]\\s]+))(?::(\\d{1,5}))?");

  /** Reads {@code HOST[:OFFSET]}; empty where it is something else. */
  public static Optional<TargetAddress> parse(String text) {
    Matcher form = FORM.matcher(text);
    if (!form.matches()) {
      return Optional.empty();
    }
    int offset = form.group(3) == null ? 0 : Integer.parseInt(form.group(3));
    String host = form.group(1) == null ? form.group(2) : form.group(1);
    return offset <= MAX_OFFSET ? Optional.of(new TargetAddress(host, offset)) : Optional.empty();
  }

  InetSocketAddress dashboard() {
    return new InetSocketAddress(host, DASHBOARD + offset);
  }

  InetSocketAddress primary() {
    return new InetSocketAddress(host, PRIMARY + offset);
  }

  InetSocketAddress rtde() {
    return new InetSocketAddress(host, RTDE + offset);
  }
}

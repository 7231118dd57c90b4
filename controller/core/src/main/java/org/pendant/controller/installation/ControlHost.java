package org.pendant.controller.installation;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Control host: the computer that External Control nodes get their script from.
 *
 * @param host its name or address
 * @param port where a driver answers there
 */
public record ControlHost(String host, int port) {
  /** What the URCap of that name asks unless it is told another one. */
  public static final ControlHost STANDARD = new ControlHost("192.168.56.1", 50002);

  private static final int MAX_PORT = 65_535;

  /** Names of the DNS, addresses of both kinds, with a zone perhaps. */
  private static final Pattern HOST = Pattern.compile("[A-Za-z0-9_.:%-]{1,253}");

  private static final Pattern WRITTEN =
      Pattern.compile("(?:\\[([^\\[\\]]+)\\]|([^:]+))(?::([0-9]{1,5}))?");

  /**
   * What a person has written: a host, and perhaps a port after a colon; an address with colons
   * stands in brackets then.
   *
   * @throws IllegalArgumentException when it is something else; the message says what is expected
   */
  public static ControlHost parse(String text) {
    boolean bareAddress = text.indexOf(':') != text.lastIndexOf(':') && !text.startsWith("[");
    if (bareAddress) {
      return checked(new ControlHost(text, STANDARD.port));
    }
    Matcher written = WRITTEN.matcher(text);
    if (!written.matches()) {
      throw new IllegalArgumentException(SetupTexts.text("noHost", text, STANDARD.text()));
    }
    String host = written.group(1) == null ? written.group(2) : written.group(1);
    String port = written.group(3);
    return checked(new ControlHost(host, port == null ? STANDARD.port : Integer.parseInt(port)));
  }

  private static ControlHost checked(ControlHost host) {
    Optional<String> problem = host.problem();
    if (problem.isPresent()) {
      throw new IllegalArgumentException(problem.get());
    }
    return host;
  }

  /** Why it cannot be; empty if it can. */
  public Optional<String> problem() {
    if (!HOST.matcher(host).matches()) {
      return Optional.of(SetupTexts.text("hostRange", host));
    }
    return port >= 1 && port <= MAX_PORT
        ? Optional.empty()
        : Optional.of(SetupTexts.text("portRange", port, MAX_PORT));
  }

  /** As people write it, such as {@code 192.168.56.1:50002}. */
  public String text() {
    return (host.contains(":") ? "[" + host + "]" : host) + ":" + port;
  }
}

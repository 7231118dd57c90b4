package org.pendant.protocols.egress;

import static org.pendant.protocols.egress.EgressTexts.text;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Allowed hosts: which computers scripts may connect to. Immutable. */
public final class AllowedHosts {
  /** Every computer. */
  public static final AllowedHosts ANY = new AllowedHosts(true, List.of());

  private static final String LOCALHOST = "localhost";

  private final boolean any;
  private final List<Entry> entries;

  private sealed interface Entry {}

  /** A host by its name, in lower case. */
  private record Name(String name) implements Entry {}

  /** The addresses that agree with {@code address} in the first {@code bits} bits. */
  private record Network(InetAddress address, int bits) implements Entry {}

  private AllowedHosts(boolean any, List<Entry> entries) {
    this.any = any;
    this.entries = List.copyOf(entries);
  }

  /**
   * What a person has written.
   *
   * @param text {@code any}, {@code none}, or names, addresses and networks such as {@code
   *     192.168.0.0/24} with commas between
   * @throws IllegalArgumentException when it is something else; the message says what is expected
   */
  public static AllowedHosts parse(String text) {
    if (text.equals("any")) {
      return ANY;
    }
    List<Entry> entries = new ArrayList<>();
    if (!text.equals("none")) {
      for (String part : text.split(",", -1)) {
        entries.add(entry(part.strip()));
      }
    }
    return new AllowedHosts(false, entries);
  }

  private static Entry entry(String text) {
    int slash = text.indexOf('/');
    if (slash >= 0) {
      InetAddress address = literal(text.substring(0, slash), text);
      return new Network(address, bits(text.substring(slash + 1), address, text));
    }
    if (isLiteral(text)) {
      InetAddress address = InetAddress.ofLiteral(text);
      return new Network(address, address.getAddress().length * Byte.SIZE);
    }
    if (!text.matches("[A-Za-z0-9_]([A-Za-z0-9_.-]*[A-Za-z0-9_.])?")) {
      throw wrong(text);
    }
    return new Name(text.toLowerCase(Locale.ROOT));
  }

  /** Whether {@code text} is an address rather than a name. */
  static boolean isLiteral(String text) {
    try {
      InetAddress.ofLiteral(text);
      return true;
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  private static InetAddress literal(String address, String text) {
    if (!isLiteral(address)) {
      throw wrong(text);
    }
    return InetAddress.ofLiteral(address);
  }

  private static int bits(String number, InetAddress address, String text) {
    if (!number.matches("[0-9]{1,3}")
        || Integer.parseInt(number) > address.getAddress().length * Byte.SIZE) {
      throw wrong(text);
    }
    return Integer.parseInt(number);
  }

  private static IllegalArgumentException wrong(String text) {
    return new IllegalArgumentException(text("noHost", text));
  }

  /**
   * Whether a name server may be asked for the addresses of a name. A question tells the name to
   * others, so only names that the user has written are asked for; networks allow addresses.
   */
  boolean mayAskFor(String name) {
    return any
        || entries.stream()
            .anyMatch(entry -> entry instanceof Name(String allowed) && same(allowed, name));
  }

  private static boolean same(String allowed, String name) {
    return allowed.equals(name.toLowerCase(Locale.ROOT));
  }

  /**
   * Whether a script may connect to an address.
   *
   * @param name the host as the script calls it
   */
  public boolean allows(String name, InetAddress address) {
    return any || entries.stream().anyMatch(entry -> matches(entry, name, address));
  }

  private static boolean matches(Entry entry, String name, InetAddress address) {
    return switch (entry) {
      case Name(String allowed) ->
          same(allowed, name) || (allowed.equals(LOCALHOST) && address.isLoopbackAddress());
      case Network(InetAddress network, int bits) ->
          agree(network.getAddress(), address.getAddress(), bits);
    };
  }

  private static boolean agree(byte[] network, byte[] address, int bits) {
    if (network.length != address.length) {
      return false;
    }
    for (int i = 0; i < bits; i++) {
      int mask = 0x80 >> i % Byte.SIZE;
      if (((network[i / Byte.SIZE] ^ address[i / Byte.SIZE]) & mask) != 0) {
        return false;
      }
    }
    return true;
  }
}

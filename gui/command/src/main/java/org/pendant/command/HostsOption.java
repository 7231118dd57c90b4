package org.pendant.command;

import org.pendant.protocols.egress.AllowedHosts;

/** {@code --allow-hosts}: how far programs may reach. */
final class HostsOption {
  static final Option OPTION =
      new Option(
          "--allow-hosts",
          "any|none|HOST,...",
          "computers that programs may connect to, default any; names, addresses, networks");

  private HostsOption() {}

  static AllowedHosts of(Arguments arguments) throws UsageException {
    try {
      return AllowedHosts.parse(arguments.value(OPTION).orElse("any"));
    } catch (IllegalArgumentException e) {
      throw new UsageException(OPTION.name() + ": " + e.getMessage());
    }
  }
}

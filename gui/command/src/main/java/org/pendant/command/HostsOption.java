package org.pendant.command;

import org.pendant.command.text.CommandLanguage;
import org.pendant.protocols.egress.AllowedHosts;

/** Option {@code --allow-hosts}: how far programs may reach. */
final class HostsOption {
  static final Option OPTION =
      Option.text("--allow-hosts", "any|none|HOST,...")
          .standing("any")
          .documented(
              "any",
              "which computers programs may connect to: `any` (default), `none`, or names,"
                  + " addresses and networks with commas between, see [outside.md](outside.md)");

  private HostsOption() {}

  static AllowedHosts of(Arguments arguments) throws UsageException {
    try {
      return AllowedHosts.parse(arguments.text(OPTION));
    } catch (IllegalArgumentException e) {
      throw new UsageException(OPTION.name() + ": " + CommandLanguage.shown(e.getMessage()));
    }
  }
}

package org.pendant.command;

import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.installation.ControlHost;
import org.pendant.protocols.externalcontrol.Drivers;

/** Option {@code --external-control}: whom External Control nodes ask for their script. */
final class ControlOption {
  static final Option OPTION =
      Option.text("--external-control", "HOST[:PORT]")
          .documented(
              "127.0.0.1:50002",
              "the driver that [External Control](external-control.md) nodes get their script from,"
                  + " whatever installations say");

  private ControlOption() {}

  /** The drivers that may be asked, {@link HostsOption} considered. */
  static Drivers of(Arguments arguments) throws UsageException {
    Optional<String> host = arguments.value(OPTION);
    try {
      return new Drivers(HostsOption.of(arguments), host.map(ControlHost::parse));
    } catch (IllegalArgumentException e) {
      throw new UsageException(OPTION.name() + ": " + CommandLanguage.shown(e.getMessage()));
    }
  }
}

package org.pendant.protocols.externalcontrol;

import java.util.Optional;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ControlScript;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.egress.HostPolicy;

/**
 * Drivers that can be asked for the script of External Control nodes. Any thread.
 *
 * @param hostPolicy the way to them
 * @param chosen whom to ask whatever installations say
 */
public record Drivers(HostPolicy hostPolicy, Optional<ControlHost> chosen) {
  /** None may be asked. */
  public static final Drivers NONE = new Drivers(AllowedHosts.parse("none"), Optional.empty());

  /** Those on {@code allowed} computers. */
  public Drivers(AllowedHosts allowed, Optional<ControlHost> chosen) {
    this(new HostPolicy(allowed), chosen);
  }

  /** Whom programs in an installation ask. */
  public ControlHost of(Installation installation) {
    return chosen.orElse(installation.controlHost());
  }

  /**
   * A request for a script, for a caller that may have to {@link ScriptRequest#cancel cancel} it
   * before it begins.
   *
   * @param nodes how often {@link ControlScript#loop} will stand in the program, at least 1
   */
  public ScriptRequest request(Installation installation, int nodes) {
    return new ScriptRequest(
        hostPolicy, of(installation), ScriptRequest.largestBytes(nodes), Patience.STANDARD);
  }
}

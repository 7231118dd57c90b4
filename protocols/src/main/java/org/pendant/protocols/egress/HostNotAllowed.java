package org.pendant.protocols.egress;

import static org.pendant.protocols.egress.EgressTexts.text;

import java.net.ConnectException;

/** Host refusal: a script asked for a connection that the user does not allow. */
public final class HostNotAllowed extends ConnectException {
  private static final long serialVersionUID = 1L;

  HostNotAllowed() {
    super(text("notAmongTheAllowedHosts"));
  }
}

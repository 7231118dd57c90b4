package org.pendant.protocols.egress;

import java.net.ConnectException;

/** A script wanted to go where the user does not allow it. */
public final class HostNotAllowed extends ConnectException {
  private static final long serialVersionUID = 1L;

  HostNotAllowed() {
    super("not among the allowed hosts");
  }
}

package org.pendant.protocols.net;

/** Protocol that is spoken at a port. */
@FunctionalInterface
public interface Protocol {
  /**
   * A peer has connected. A greeting may be sent at once.
   *
   * @param connection to answer by
   */
  Session connected(Connection connection);
}

package org.pendant.protocols.externalcontrol;

/** A driver has sent no script; the message says who should have, and what is wrong. */
public final class NoScript extends Exception {
  private static final long serialVersionUID = 1L;

  NoScript(String message) {
    super(message);
  }
}
